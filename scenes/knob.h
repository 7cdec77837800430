// What of a scene may be changed without a rebuild: numbers, choices and file patterns.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace plait {

enum class Quality { draft, preview, final };

// One knob, as `describe` shows it. A knob with `choices` takes one of them; one with neither
// choices nor a range (low = high) takes a file or a file pattern, "" for none.
struct Knob {
    std::string name;
    std::string meaning;
    std::string unit = "";
    double value = 0;  // the default of a number
    double low = 0, high = 0;
    std::vector<std::string> choices = {};
    std::string text = "";  // the default of a choice or a file

    bool isNumber() const { return low < high; }
    bool isFile() const { return !isNumber() && choices.empty(); }
};

// The values that a scene is built with.
struct Knobs {
    Quality quality = Quality::preview;
    std::uint64_t seed = 1;  // of whatever is random
    std::map<std::string, double> numbers;
    std::map<std::string, std::string> texts;

    // The defaults of `knobs` in this quality.
    static Knobs defaults(const std::vector<Knob>& knobs, Quality quality);

    double number(const std::string& name) const { return numbers.at(name); }
    const std::string& text(const std::string& name) const { return texts.at(name); }
    // One of three by quality.
    template <class T>
    T byQuality(T draft, T preview, T final) const {
        return quality == Quality::draft ? draft : quality == Quality::preview ? preview : final;
    }
};

}  // namespace plait
