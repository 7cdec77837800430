// The dictionary: words of Nucleus and of Vellum, and what each is here.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace plait {

struct SeedWord {
    std::string seed;               // "Nucleus" or "Vellum"
    std::string word;               // as users of that program know it
    std::string here;               // what it is in Plait, or what takes its place
    std::vector<std::string> rows;  // of the seeds: where it comes from
};

// By seed, then in the order of its own manual.
std::span<const SeedWord> seedWords();
std::vector<SeedWord> nucleusWords();
std::vector<SeedWord> vellumWords();

// Of a word's row on the page of the dictionary.
std::string anchorOf(const SeedWord& word);

}  // namespace plait
