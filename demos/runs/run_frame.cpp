#include "run_frame.h"

#include "demos/tools/errors.h"

#include <plait/measure/hash.h>

#include <cstring>
#include <span>

namespace plait {
namespace {

struct Format {
    const char* magic;  // 8 characters
    std::uint32_t version;
};
constexpr Format frameFormat{"plaitfrm", 2}, checkpointFormat{"plaitchk", 6};

class Writer {
public:
    Writer(const Format& format, std::size_t numberSize) {
        bytes_.append(format.magic, 8);
        put(format.version);
        put(static_cast<std::uint32_t>(numberSize));
    }
    template <class T>
    void put(const T& value) {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    template <class T>
    void put(const std::vector<T>& values) {
        bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    }
    std::string finish() {
        put(hashOf(bytes_));
        return std::move(bytes_);
    }

private:
    std::string bytes_;
};

class Reader {
public:
    Reader(const std::string& bytes, const Format& format, const std::string& name)
        : bytes_(bytes), name_(name) {
        if (bytes.size() < 24 || bytes.compare(0, 8, format.magic, 8) != 0)
            fail("not of this format");
        std::uint64_t hash;
        std::memcpy(&hash, bytes.data() + bytes.size() - sizeof hash, sizeof hash);
        bytes_.remove_suffix(sizeof hash);
        if (hash != hashOf(bytes_)) fail("damaged");
        bytes_.remove_prefix(8);
        if (get<std::uint32_t>() != format.version) fail("of another version");
        numberSize = get<std::uint32_t>();
    }
    template <class T>
    T get() {
        T value;
        take(&value, sizeof value);
        return value;
    }
    template <class T>
    std::vector<T> get(std::int64_t count) {
        if (count < 0 || count > static_cast<std::int64_t>(bytes_.size() / sizeof(T)))
            fail("too short");
        std::vector<T> values(static_cast<std::size_t>(count));
        take(values.data(), values.size() * sizeof(T));
        return values;
    }
    [[noreturn]] void fail(const char* what) const { throw FileError(name_ + ": " + what); }

    std::uint32_t numberSize = 0;

private:
    void take(void* to, std::size_t size) {
        if (bytes_.size() < size) fail("too short");
        if (size) std::memcpy(to, bytes_.data(), size);
        bytes_.remove_prefix(size);
    }

    std::string_view bytes_;
    std::string name_;
};

template <class Real>
void putVectors(Writer& writer, const std::vector<Vec<double>>& vectors) {
    std::vector<Real> numbers;
    numbers.reserve(3 * vectors.size());
    for (const Vec<double>& v : vectors)
        for (const double a : {v.x, v.y, v.z}) numbers.push_back(static_cast<Real>(a));
    writer.put(numbers);
}

template <class Real>
std::vector<Vec<double>> getVectors(Reader& reader, int count) {
    const std::vector<Real> numbers = reader.get<Real>(3 * std::int64_t{count});
    std::vector<Vec<double>> vectors;
    vectors.reserve(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < numbers.size(); i += 3)
        vectors.push_back({double(numbers[i]), double(numbers[i + 1]), double(numbers[i + 2])});
    return vectors;
}

}  // namespace

std::string encodeFrame(const RunFrame& frame, int size) {
    Writer writer(frameFormat, static_cast<std::size_t>(size));
    for (const std::size_t n : {static_cast<std::size_t>(frame.number), frame.positions.size(),
                                frame.metrics.size(), frame.ids.size(), frame.cuts.size()})
        writer.put(static_cast<std::int32_t>(n));
    writer.put(frame.time);
    writer.put(static_cast<std::int64_t>(frame.evaluations));
    writer.put(frame.seconds);
    writer.put(frame.metrics);
    for (const auto* vectors : {&frame.positions, &frame.velocities})
        size == sizeof(float) ? putVectors<float>(writer, *vectors)
                              : putVectors<double>(writer, *vectors);
    writer.put(frame.touched);
    writer.put(frame.ids);
    writer.put(frame.ages);
    writer.put(frame.cuts);
    return writer.finish();
}

RunFrame decodeFrame(const std::string& bytes, const std::string& name) {
    Reader reader(bytes, frameFormat, name);
    RunFrame frame;
    frame.number = reader.get<std::int32_t>();
    const int vertices = reader.get<std::int32_t>(), metrics = reader.get<std::int32_t>();
    const int comers = reader.get<std::int32_t>(), cuts = reader.get<std::int32_t>();
    frame.time = reader.get<double>();
    frame.evaluations = reader.get<std::int64_t>();
    frame.seconds = reader.get<double>();
    frame.metrics = reader.get<double>(metrics);
    for (auto* vectors : {&frame.positions, &frame.velocities})
        *vectors = reader.numberSize == sizeof(float) ? getVectors<float>(reader, vertices)
                                                      : getVectors<double>(reader, vertices);
    frame.touched = reader.get<std::uint8_t>(vertices);
    frame.ids = reader.get<std::int32_t>(comers);
    frame.ages = reader.get<double>(comers);
    frame.cuts = reader.get<std::int32_t>(cuts);
    return frame;
}

template <class Real>
std::string encodeCheckpoint(const Checkpoint<Real>& checkpoint) {
    const State<Real>& state = checkpoint.state;
    Writer writer(checkpointFormat, sizeof(Real));
    writer.put(static_cast<std::int32_t>(checkpoint.frame));
    writer.put(static_cast<std::int64_t>(state.substep));
    writer.put(static_cast<std::int64_t>(checkpoint.evaluations));
    writer.put(static_cast<std::int32_t>(state.hasPast));
    const auto put = [&](const auto& array) {
        writer.put(static_cast<std::int64_t>(array.size()));
        writer.put(array);
    };
    State<Real>::forArrays(state, put);
    put(state.id), put(state.born), put(state.cuts);
    writer.put(static_cast<std::int64_t>(state.kept.size()));
    for (const Drawer<Real>& drawer : state.kept) {
        put(drawer.numbers);
        put(drawer.integers);
    }
    return writer.finish();
}

template <class Real>
Checkpoint<Real> decodeCheckpoint(const std::string& bytes, const std::string& name) {
    Reader reader(bytes, checkpointFormat, name);
    if (reader.numberSize != sizeof(Real)) reader.fail("of another precision");
    Checkpoint<Real> checkpoint;
    State<Real>& state = checkpoint.state;
    checkpoint.frame = reader.get<std::int32_t>();
    state.substep = reader.get<std::int64_t>();
    checkpoint.evaluations = reader.get<std::int64_t>();
    state.hasPast = reader.get<std::int32_t>() != 0;
    const auto take = [&]<class T>(std::vector<T>& array) {
        array = reader.get<T>(reader.get<std::int64_t>());
    };
    State<Real>::forArrays(state, take);
    take(state.id), take(state.born), take(state.cuts);
    const auto drawers = reader.get<std::int64_t>();
    for (std::int64_t i = 0; i < drawers; ++i) {
        Drawer<Real>& drawer = state.kept.emplace_back();
        take(drawer.numbers);
        take(drawer.integers);
    }
    return checkpoint;
}

template std::string encodeCheckpoint(const Checkpoint<float>&);
template std::string encodeCheckpoint(const Checkpoint<double>&);
template Checkpoint<float> decodeCheckpoint(const std::string&, const std::string&);
template Checkpoint<double> decodeCheckpoint(const std::string&, const std::string&);

}  // namespace plait
