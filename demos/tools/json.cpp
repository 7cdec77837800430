#include "json.h"

#include "words.h"

#include <cmath>
#include <cstdio>

namespace plait {
namespace {

std::string quoted(const std::string& value) {
    std::string text = "\"";
    for (const char c : value) {
        if (c == '"' || c == '\\') text += '\\';
        if (static_cast<unsigned char>(c) >= ' ') {
            text += c;
            continue;
        }
        char code[8];
        std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(c));
        text += code;
    }
    return text + '"';
}

}  // namespace

JsonWriter& JsonWriter::put(const std::string& key, const std::string& value) {
    if (!closing_.empty()) text_ += (empty_ ? "\n" : ",\n") + std::string(2 * closing_.size(), ' ');
    if (!key.empty()) text_ += quoted(key) + ": ";
    text_ += value;
    empty_ = false;
    return *this;
}

JsonWriter& JsonWriter::open(const std::string& key, char bracket) {
    put(key, std::string(1, bracket));
    closing_ += bracket == '{' ? '}' : ']';
    empty_ = true;
    return *this;
}

JsonWriter& JsonWriter::end() {
    const char bracket = closing_.back();
    closing_.pop_back();
    if (!empty_) text_ += "\n" + std::string(2 * closing_.size(), ' ');
    text_ += bracket;
    empty_ = false;
    return *this;
}

JsonWriter& JsonWriter::field(const std::string& key, const std::string& value) {
    return put(key, quoted(value));
}
JsonWriter& JsonWriter::field(const std::string& key, const char* value) {
    return put(key, quoted(value));
}
JsonWriter& JsonWriter::field(const std::string& key, double value) {
    return put(key, std::isfinite(value) ? text(value) : "null");
}
JsonWriter& JsonWriter::field(const std::string& key, long value) {
    return put(key, std::to_string(value));
}
JsonWriter& JsonWriter::field(const std::string& key, bool value) {
    return put(key, value ? "true" : "false");
}

std::string JsonWriter::finish() {
    while (!closing_.empty()) end();
    return text_ + "\n";
}

}  // namespace plait
