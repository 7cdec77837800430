// Words that people type: numbers with their range, names with the nearest one that exists.
#pragma once

#include <string>
#include <vector>

namespace plait {

// Letters to insert, delete, change or swap with a neighbour to make one word of the other
// (optimal string alignment).
int editDistance(const std::string& a, const std::string& b);

// The first of `words` least far from `word`; "" of none.
std::string nearest(const std::string& word, const std::vector<std::string>& words);

// "a, b, c".
std::string joined(const std::vector<std::string>& words);

// As one word of a POSIX shell: quoted unless it is plain.
std::string shellWord(const std::string& word);

// The shortest text that reads back as the same number.
std::string text(double value);
std::string text(float value);

// The whole of `word` as a number in [low, high]. Throws UsageError that begins with `what`.
double parseNumber(const std::string& what, const std::string& word, double low, double high);
long parseInteger(const std::string& what, const std::string& word, long low, long high);

// Place of `word` among `words`. Throws UsageError that begins with `what` and names the nearest
// and all of them.
int parseChoice(const std::string& what, const std::string& word,
                const std::vector<std::string>& words);

}  // namespace plait
