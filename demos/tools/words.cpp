#include "words.h"

#include "errors.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace plait {
namespace {

template <class Number>
std::string shortest(Number value) {
    char buffer[64];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    return {buffer, end};
}

template <class Number>
Number parse(const std::string& what, const std::string& word, const char* kind, Number low,
             Number high) {
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole = error == std::errc{} && end == word.data() + word.size();
    if (!whole || !(value >= low && value <= high))
        throw UsageError(what + ": '" + word + "' is not " + kind + " from " + shortest(low) +
                         " to " + shortest(high));
    return value;
}

}  // namespace

int editDistance(const std::string& a, const std::string& b) {
    const std::size_t n = a.size(), m = b.size();
    std::vector<std::vector<int>> d(n + 1, std::vector<int>(m + 1));
    for (std::size_t i = 0; i <= n; ++i) d[i][0] = static_cast<int>(i);
    for (std::size_t j = 0; j <= m; ++j) d[0][j] = static_cast<int>(j);
    for (std::size_t i = 1; i <= n; ++i)
        for (std::size_t j = 1; j <= m; ++j) {
            const int change = a[i - 1] == b[j - 1] ? 0 : 1;
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[n][m];
}

std::string nearest(const std::string& word, const std::vector<std::string>& words) {
    const auto best =
        std::min_element(words.begin(), words.end(), [&](const auto& a, const auto& b) {
            return editDistance(word, a) < editDistance(word, b);
        });
    return best == words.end() ? "" : *best;
}

std::string joined(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) line += (line.empty() ? "" : ", ") + word;
    return line;
}

std::string shellWord(const std::string& word) {
    constexpr const char* plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

std::string text(double value) { return shortest(value); }
std::string text(float value) { return shortest(value); }

double parseNumber(const std::string& what, const std::string& word, double low, double high) {
    return parse(what, word, "a number", low, high);
}

long parseInteger(const std::string& what, const std::string& word, long low, long high) {
    return parse(what, word, "a whole number", low, high);
}

int parseChoice(const std::string& what, const std::string& word,
                const std::vector<std::string>& words) {
    const auto found = std::find(words.begin(), words.end(), word);
    if (found != words.end()) return static_cast<int>(found - words.begin());
    const std::string rest =
        words.empty() ? "; there is none"
                      : "; nearest: " + nearest(word, words) + "; there is: " + joined(words);
    throw UsageError(what + ": no '" + word + "'" + rest);
}

}  // namespace plait
