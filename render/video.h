// Pictures to moving pictures.
#pragma once

#include "render/pictures/picture.h"
#include "render/pictures/whole_file.h"

#include <plait/schedule.h>

#include <cstdint>
#include <filesystem>
#include <memory>

struct AVCodecContext;
struct AVFormatContext;
struct AVFrame;
struct AVPacket;
struct SwsContext;

namespace plait {

// By the ending of the file: .mp4 is H.264 for every player (crf 18, 4:2:0, BT.709, index in
// front); .webp an animation that loops, small enough for a README. The same pictures give the same
// bytes. The file appears whole, by finish(), or not at all. Throws FileError (whole_file.h).
class VideoWriter {
public:
    // Throws std::invalid_argument for sizes that are not even and at least 16, rates that are not
    // positive and other endings.
    VideoWriter(const std::filesystem::path& path, int width, int height, FrameRate rate);
    ~VideoWriter();

    // The next frame. A picture of another size is scaled: give it the same aspect.
    void add(const Picture& picture);
    // No frame may be added after it. Throws std::invalid_argument if there was none before.
    void finish();

private:
    struct Free {
        void operator()(AVCodecContext* codec) const;
        void operator()(AVFormatContext* container) const;
        void operator()(AVFrame* frame) const;
        void operator()(AVPacket* packet) const;
        void operator()(SwsContext* scaler) const;
    };

    void check(int status) const;
    void openCodec(bool webp, int width, int height, FrameRate rate);
    void openContainer(bool webp);
    void writePackets();

    WholeFile file_;
    std::unique_ptr<AVFormatContext, Free> container_;
    std::unique_ptr<AVCodecContext, Free> codec_;
    std::unique_ptr<AVFrame, Free> frame_;
    std::unique_ptr<AVPacket, Free> packet_;
    std::unique_ptr<SwsContext, Free> scaler_;
    std::int64_t frames_ = 0;
};

}  // namespace plait
