#include "video_reader.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace plait::test {
namespace {

Picture toPicture(const AVFrame* frame) {
    Picture picture{frame->width, frame->height, {}};
    picture.rgb.resize(static_cast<std::size_t>(3 * frame->width * frame->height));
    const auto format = static_cast<AVPixelFormat>(frame->format);
    SwsContext* scaler = sws_getContext(
        frame->width, frame->height, format, frame->width, frame->height, AV_PIX_FMT_RGB24,
        SWS_BICUBIC | SWS_FULL_CHR_H_INT | SWS_ACCURATE_RND, nullptr, nullptr, nullptr);
    sws_setColorspaceDetails(scaler, sws_getCoefficients(frame->colorspace),
                             frame->color_range == AVCOL_RANGE_JPEG,
                             sws_getCoefficients(SWS_CS_DEFAULT), 1, 0, 1 << 16, 1 << 16);
    std::uint8_t* target[] = {picture.rgb.data()};
    const int stride[] = {3 * frame->width};
    sws_scale(scaler, frame->data, frame->linesize, 0, frame->height, target, stride);
    sws_freeContext(scaler);
    return picture;
}

}  // namespace

Video readVideo(const std::filesystem::path& path) {
    AVFormatContext* container = nullptr;
    if (avformat_open_input(&container, path.c_str(), nullptr, nullptr) < 0 ||
        avformat_find_stream_info(container, nullptr) < 0 || container->nb_streams != 1)
        throw std::runtime_error(path.string() + ": no video");
    const AVStream* stream = container->streams[0];
    const AVCodec* decoder = avcodec_find_decoder(stream->codecpar->codec_id);
    AVCodecContext* codec = avcodec_alloc_context3(decoder);
    avcodec_parameters_to_context(codec, stream->codecpar);
    codec->thread_count = 1;
    if (avcodec_open2(codec, decoder, nullptr) < 0)
        throw std::runtime_error(path.string() + ": no decoder");
    Video video{.width = codec->width,
                .height = codec->height,
                .rateFrames = stream->avg_frame_rate.num,
                .rateSeconds = stream->avg_frame_rate.den,
                .codec = decoder->name,
                .pixelFormat = av_get_pix_fmt_name(codec->pix_fmt),
                .colorSpace = av_color_space_name(codec->colorspace),
                .colorRange = av_color_range_name(codec->color_range),
                .frames = {},
                .times = {}};
    AVPacket* packet = av_packet_alloc();
    AVFrame* frame = av_frame_alloc();
    for (bool more = true; more;) {
        more = av_read_frame(container, packet) >= 0;
        if (avcodec_send_packet(codec, more ? packet : nullptr) < 0)
            throw std::runtime_error(path.string() + ": is broken");
        av_packet_unref(packet);
        while (avcodec_receive_frame(codec, frame) >= 0) {
            video.frames.push_back(toPicture(frame));
            video.times.push_back(static_cast<double>(frame->pts) * av_q2d(stream->time_base));
        }
    }
    av_frame_free(&frame);
    av_packet_free(&packet);
    avcodec_free_context(&codec);
    avformat_close_input(&container);
    return video;
}

std::vector<Box> boxes(const std::vector<std::uint8_t>& file) {
    std::vector<Box> result;
    for (std::size_t at = 0; at + 8 <= file.size();) {
        std::uint64_t size = 0;
        for (int i = 0; i < 4; ++i) size = (size << 8) | file[at + i];
        result.push_back({{file.begin() + at + 4, file.begin() + at + 8}, size});
        if (size < 8) break;
        at += size;
    }
    return result;
}

std::vector<std::uint8_t> readBytes(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace plait::test
