#include "video.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

#include <stdexcept>
#include <string>

namespace plait {

void VideoWriter::Free::operator()(AVCodecContext* codec) const { avcodec_free_context(&codec); }
void VideoWriter::Free::operator()(AVFormatContext* container) const {
    avio_closep(&container->pb);
    avformat_free_context(container);
}
void VideoWriter::Free::operator()(AVFrame* frame) const { av_frame_free(&frame); }
void VideoWriter::Free::operator()(AVPacket* packet) const { av_packet_free(&packet); }
void VideoWriter::Free::operator()(SwsContext* scaler) const { sws_freeContext(scaler); }

VideoWriter::VideoWriter(const std::filesystem::path& path, int width, int height, FrameRate rate)
    : file_(path) {
    const bool webp = path.extension() == ".webp";
    if (!webp && path.extension() != ".mp4")
        throw std::invalid_argument(path.string() + ": a video ends in .mp4 or .webp");
    if (width < 16 || height < 16 || width % 2 != 0 || height % 2 != 0)
        throw std::invalid_argument(path.string() +
                                    ": width and height of a video are even and at "
                                    "least 16, not " +
                                    std::to_string(width) + "x" + std::to_string(height));
    if (rate.frames < 1 || rate.seconds < 1)
        throw std::invalid_argument(path.string() + ": the frame rate is not positive");
    av_log_set_level(AV_LOG_ERROR);
    openCodec(webp, width, height, rate);
    openContainer(webp);
    packet_.reset(av_packet_alloc());
    frame_.reset(av_frame_alloc());
    frame_->format = codec_->pix_fmt;
    frame_->width = width;
    frame_->height = height;
    check(av_frame_get_buffer(frame_.get(), 0));
}

VideoWriter::~VideoWriter() = default;

void VideoWriter::check(int status) const {
    if (status >= 0) return;
    char cause[AV_ERROR_MAX_STRING_SIZE] = "";
    av_strerror(status, cause, sizeof cause);
    throw FileError(file_.path().string() + ": cannot be written: " + cause);
}

void VideoWriter::openCodec(bool webp, int width, int height, FrameRate rate) {
    const char* name = webp ? "libwebp_anim" : "libx264";
    const AVCodec* encoder = avcodec_find_encoder_by_name(name);
    if (!encoder)
        throw std::runtime_error(file_.path().string() + ": this FFmpeg was built without " + name);
    codec_.reset(avcodec_alloc_context3(encoder));
    codec_->width = width;
    codec_->height = height;
    codec_->pix_fmt = AV_PIX_FMT_YUV420P;
    codec_->time_base = {rate.seconds, rate.frames};
    codec_->framerate = {rate.frames, rate.seconds};
    // x264 cuts its work by the number of threads, and the bits follow.
    codec_->thread_count = 2;
    if (webp) {
        // Decoders of WebP know BT.601 in the range of television alone.
        codec_->colorspace = AVCOL_SPC_SMPTE170M;
        check(av_opt_set_double(codec_->priv_data, "quality", 75, 0));
    } else {
        codec_->color_primaries = AVCOL_PRI_BT709;
        codec_->color_trc = AVCOL_TRC_BT709;
        codec_->colorspace = AVCOL_SPC_BT709;
        codec_->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
        check(av_opt_set(codec_->priv_data, "preset", "veryfast", 0));
        check(av_opt_set_double(codec_->priv_data, "crf", 18, 0));
    }
    codec_->color_range = AVCOL_RANGE_MPEG;
    check(avcodec_open2(codec_.get(), encoder, nullptr));
}

void VideoWriter::openContainer(bool webp) {
    AVFormatContext* container = nullptr;
    const std::string part = file_.part().string();
    check(avformat_alloc_output_context2(&container, nullptr, webp ? "webp" : "mp4", part.c_str()));
    container_.reset(container);
    container->flags |= AVFMT_FLAG_BITEXACT;  // without dates and versions
    AVStream* stream = avformat_new_stream(container, nullptr);
    stream->time_base = codec_->time_base;
    stream->avg_frame_rate = codec_->framerate;
    check(avcodec_parameters_from_context(stream->codecpar, codec_.get()));
    check(webp ? av_opt_set_int(container->priv_data, "loop", 0, 0)
               : av_opt_set(container->priv_data, "movflags", "+faststart", 0));
    check(avio_open(&container->pb, part.c_str(), AVIO_FLAG_WRITE));
    check(avformat_write_header(container, nullptr));
}

void VideoWriter::add(const Picture& picture) {
    if (picture.rgb.empty())
        throw std::invalid_argument(file_.path().string() + ": a frame without pixels");
    scaler_.reset(
        sws_getCachedContext(scaler_.release(), picture.width, picture.height, AV_PIX_FMT_RGB24,
                             codec_->width, codec_->height, codec_->pix_fmt,
                             SWS_BICUBIC | SWS_FULL_CHR_H_INP | SWS_ACCURATE_RND | SWS_BITEXACT,
                             nullptr, nullptr, nullptr));
    if (!scaler_) check(AVERROR(EINVAL));
    constexpr int unchanged = 1 << 16;
    sws_setColorspaceDetails(scaler_.get(), sws_getCoefficients(SWS_CS_DEFAULT), 1,
                             sws_getCoefficients(codec_->colorspace), 0, 0, unchanged, unchanged);
    check(av_frame_make_writable(frame_.get()));
    const std::uint8_t* source[] = {picture.rgb.data()};
    const int stride[] = {3 * picture.width};
    check(sws_scale(scaler_.get(), source, stride, 0, picture.height, frame_->data,
                    frame_->linesize));
    frame_->pts = frames_++;
    check(avcodec_send_frame(codec_.get(), frame_.get()));
    writePackets();
}

void VideoWriter::finish() {
    if (frames_ == 0)
        throw std::invalid_argument(file_.path().string() + ": a video without a frame");
    check(avcodec_send_frame(codec_.get(), nullptr));
    writePackets();
    check(av_write_trailer(container_.get()));
    check(avio_closep(&container_->pb));
    file_.commit();
}

void VideoWriter::writePackets() {
    const AVStream* stream = container_->streams[0];
    for (;;) {
        const int status = avcodec_receive_packet(codec_.get(), packet_.get());
        if (status == AVERROR(EAGAIN) || status == AVERROR_EOF) return;
        check(status);
        packet_->duration = 1;
        av_packet_rescale_ts(packet_.get(), codec_->time_base, stream->time_base);
        check(av_interleaved_write_frame(container_.get(), packet_.get()));
    }
}

}  // namespace plait
