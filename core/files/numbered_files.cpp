#include "numbered_files.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "mesh_reader.h"

namespace plait {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view digits = "0123456789";

// Bytes above ASCII are parts of letters.
bool isLetterOrDigit(char c) {
    return (c >= '0' && c <= '9') || ((c | 32) >= 'a' && (c | 32) <= 'z') || (c & 128) != 0;
}

// A pattern's name, cut at its star.
class Pattern {
public:
    explicit Pattern(const fs::path& path) : name_(path.filename().string()) {
        star_ = name_.find('*');
        if (name_.find('*', star_ + 1) != std::string::npos) failAsWhole(path, "more than one *");
    }

    bool matches(const std::string& file) const {
        const bool hidden = file.starts_with('.') && star_ == 0;
        return !hidden && file.size() + 1 >= name_.size() &&
               file.starts_with(name_.substr(0, star_)) && file.ends_with(name_.substr(star_ + 1));
    }

    // Where the last number in what stands for the star begins and ends in a name that matches;
    // both 0 for none.
    std::pair<std::size_t, std::size_t> number(const std::string& file) const {
        const std::size_t end = file.size() + star_ + 1 - name_.size();  // of what stands for it
        const std::string_view text = std::string_view(file).substr(0, end);
        const std::size_t last = text.find_last_of(digits);
        if (last == std::string::npos || last < star_) return {};
        const std::size_t before = text.find_last_not_of(digits, last);
        return {before == std::string::npos ? star_ : std::max(before + 1, star_), last + 1};
    }

private:
    std::string name_;
    std::size_t star_;
};

enum class Minus { None, Sign, Dash };

Minus minusBefore(const std::string& name, std::size_t begin) {
    if (begin == 0 || name[begin - 1] != '-') return Minus::None;
    return begin > 1 && isLetterOrDigit(name[begin - 2]) ? Minus::Dash : Minus::Sign;
}

void checkNoGaps(const NumberedFiles& files) {
    for (std::size_t i = 1; i < files.size(); ++i) {
        if (files[i].first == files[i - 1].first)
            failAsWhole(files[i].second, "the same number as " + files[i - 1].second.string());
        const long long step = files[1].first - files[0].first;
        if (files[i].first != files[i - 1].first + step)
            failAsWhole(files[i].second, "no file of number " +
                                             std::to_string(files[i - 1].first + step) +
                                             " before this one");
    }
}

}  // namespace

NumberedFiles filesOf(const fs::path& path) {
    const Pattern pattern(path);
    NumberedFiles found;
    const fs::path *dashed = nullptr, *plain = nullptr;  // a file each
    const std::vector<fs::path> paths = pathsBeside(path);
    for (const fs::path& file : paths) {
        const std::string name = file.filename().string();
        if (!pattern.matches(name)) continue;
        const auto [begin, end] = pattern.number(name);
        if (begin == end || end - begin > 18) failAsWhole(file, "no number where the * is");
        const long long number = std::stoll(name.substr(begin, end - begin));
        const Minus minus = minusBefore(name, begin);
        if (minus == Minus::Dash) dashed = &file;
        if (minus == Minus::None) plain = &file;
        found.emplace_back(minus == Minus::Sign ? -number : number, file);
    }
    if (found.empty()) failAsWhole(path, "no file matches");
    if (dashed && plain)
        failAsWhole(*dashed, "its - may be a dash or a sign: " + plain->string() + " has none");
    std::sort(found.begin(), found.end());
    checkNoGaps(found);
    return found;
}

}  // namespace plait
