// JSON, written as it comes.
#pragma once

#include <string>

namespace plait {

class JsonWriter {
public:
    JsonWriter() { open("", '{'); }

    // An object or array begins; `key` is "" within an array.
    JsonWriter& beginObject(const std::string& key) { return open(key, '{'); }
    JsonWriter& beginArray(const std::string& key) { return open(key, '['); }
    JsonWriter& end();

    JsonWriter& field(const std::string& key, const std::string& value);
    JsonWriter& field(const std::string& key, const char* value);
    JsonWriter& field(const std::string& key, double value);  // null where not finite
    JsonWriter& field(const std::string& key, long value);
    JsonWriter& field(const std::string& key, int value) { return field(key, long{value}); }
    JsonWriter& field(const std::string& key, bool value);

    // The whole text, everything that is open being closed.
    std::string finish();

private:
    JsonWriter& open(const std::string& key, char bracket);
    JsonWriter& put(const std::string& key, const std::string& value);

    std::string text_, closing_;
    bool empty_ = true;  // the object or array that is open
};

}  // namespace plait
