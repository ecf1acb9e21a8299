#include <sound/sound_file.h>

#include <cmath>
#include <stdexcept>

#include <fettle/property/error.h>
#include <fettle/property/exception_text.h>
#include <fettle/property/storage/scene.h>

#include <sfml/sfml_audio.h>

namespace fettle::app {

namespace {

constexpr std::uint64_t block_frames = 4096;
constexpr double longest = 24 * 3600.0;  // s

constexpr unsigned most_channels = 8;

std::size_t number_at(const std::string& bytes, std::size_t at, std::size_t size) {
    std::size_t number = 0;
    for (std::size_t i = size; i-- > 0;)
        number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
    return number;
}

/// A WAV file with which SFML ends the program: it divides by zero if the samples come before their
/// format, and version 3 has no positions for more than eight channels. That version also reads
/// the variants of the format that store numbers in other ways.
bool ends_the_program(const std::string& bytes) {
    for (const char* variant : {"RIFX", "RF64", "riff", "FORM"})
        if (bytes.starts_with(variant)) return true;
    constexpr std::size_t head = 12;  // "RIFF", a size, "WAVE"
    if (!bytes.starts_with("RIFF")) return false;
    for (std::size_t at = head; at + 8 <= bytes.size();) {
        const std::string_view name(bytes.data() + at, 4);
        if (name == "data") return true;
        if (name == "fmt ") {
            if (at + 12 > bytes.size()) return true;
            const std::size_t channels = number_at(bytes, at + 10, 2);
            return channels < 1 || channels > most_channels;
        }
        at += 8 + number_at(bytes, at + 4, 4);
    }
    return true;
}

/// WAV and FLAC files state how long they are, and a file that was cut off still states the old
/// length.
bool is_cut_off(const std::string& bytes, sf::InputSoundFile& file) {
    const std::uint64_t samples = file.getSampleCount(), last = file.getChannelCount();
    if (bytes.starts_with("RIFF")) return samples > bytes.size();
    if (!bytes.starts_with("fLaC")) return false;
    std::int16_t frame[most_channels];
    file.seek(samples - last);
    return file.read(frame, last) < last;
}

}  // namespace

Stereo Samples::frame(std::uint64_t index) const {
    const std::uint64_t at = index * channels;
    if (at + channels > values.size()) return {};
    const auto level = [&](std::uint64_t i) { return static_cast<float>(values[i]) / 32768.0f; };
    const float left = level(at);
    return {left, channels == 1 ? left : level(at + 1)};
}

SoundFile::SoundFile(std::string bytes) : bytes_(std::move(bytes)) {
    const sfml::NoMessages quiet;
    sf::InputSoundFile file;
    if (ends_the_program(bytes_) || !file.openFromMemory(bytes_.data(), bytes_.size()))
        throw std::invalid_argument(
            "it is damaged, or in a format that cannot be played; WAV (PCM), OGG (Vorbis) and "
            "FLAC can, and MP3 with SFML 2.6 or newer");
    rate_ = file.getSampleRate();
    channels_ = file.getChannelCount();
    if (rate_ < 1000 || rate_ > 400000 || channels_ < 1 || channels_ > most_channels)
        throw std::invalid_argument("it is damaged: " + std::to_string(channels_) +
                                    " channels of " + std::to_string(rate_) + " Hz");
    const std::uint64_t samples = file.getSampleCount();
    frames_ = samples / channels_;
    if (frames_ == 0) throw std::invalid_argument("it is empty or damaged: it has no samples");
    if (duration() > longest || is_cut_off(bytes_, file))
        throw std::invalid_argument("it is damaged: it says that it is " +
                                    property::number_text(std::round(10.0 * duration()) / 10.0) +
                                    " s long, and is too short for that");
}

std::size_t SoundFile::decoded_size() const {
    return static_cast<std::size_t>(frames_) * channels_ * sizeof(std::int16_t);
}

std::shared_ptr<const Samples> SoundFile::samples() const {
    if (samples_ != nullptr) return samples_;
    const auto all = std::make_shared<Samples>();
    all->rate = rate_;
    all->channels = channels_;
    sf::InputSoundFile file;
    const sfml::NoMessages quiet;
    if (file.openFromMemory(bytes_.data(), bytes_.size())) {
        // A damaged file may have fewer samples than it states.
        constexpr std::size_t piece = std::size_t{1} << 16;
        for (std::size_t size = 0; size * sizeof(std::int16_t) < decoded_size();) {
            all->values.resize(size + piece);
            const std::uint64_t count = file.read(all->values.data() + size, piece);
            size += static_cast<std::size_t>(count);
            all->values.resize(size);
            if (count == 0) break;
        }
    }
    return samples_ = all;
}

struct SoundReader::Decoder {
    sf::InputSoundFile file;
};

SoundReader::SoundReader(std::shared_ptr<const SoundFile> file)
    : file_(std::move(file)), decoder_(std::make_unique<Decoder>()), end_(file_->frames()) {
    // It could be opened before, so this cannot fail.
    (void)decoder_->file.openFromMemory(file_->bytes().data(), file_->bytes().size());
    block_.rate = file_->rate();
    block_.channels = file_->channels();
}

SoundReader::~SoundReader() = default;

Stereo SoundReader::frame(std::uint64_t index) {
    if (index >= end_) return {};
    if (index < first_ || index >= first_ + count_) load(index);
    return block_.frame(index - first_);
}

Stereo SoundReader::first_frame() {
    if (!start_) start_ = frame(0);
    return *start_;
}

/// Reads the block that begins with the frame. The last frame of the block before stays, since
/// samples between two frames need both.
void SoundReader::load(std::uint64_t index) {
    std::vector<std::int16_t>& values = block_.values;
    const std::size_t channels = block_.channels;
    const bool continues = count_ > 0 && index == next_;
    if (continues) {
        values.erase(values.begin(), values.end() - static_cast<std::ptrdiff_t>(channels));
        first_ = next_ - 1;
    } else {
        values.clear();
        first_ = next_ = index;
        decoder_->file.seek(index * channels);
    }
    const std::size_t kept = values.size();
    values.resize(kept + block_frames * channels);
    const std::uint64_t read = decoder_->file.read(values.data() + kept, block_frames * channels);
    values.resize(kept + static_cast<std::size_t>(read / channels) * channels);
    count_ = values.size() / channels;
    next_ = first_ + count_;
    if (read < block_frames * channels) end_ = next_;
    if (first_ == 0) start_ = block_.frame(0);
}

std::shared_ptr<const SoundFile> SoundFiles::get(const std::string& what, const std::string& name) {
    if (const auto found = files_.find(name); found != files_.end()) return found->second;
    auto file = read(what, name);
    files_.emplace(name, file);
    return file;
}

std::shared_ptr<const SoundFile> SoundFiles::renew(const std::string& name) {
    const auto found = files_.find(name);
    if (found == files_.end()) return nullptr;
    return found->second = read("sound", name);
}

std::shared_ptr<const SoundFile> SoundFiles::read(const std::string& what,
                                                  const std::string& name) const {
    if (assets_ == nullptr)
        throw property::Error(property::ErrorKind::rejected,
                              what + ": this game has no files, so none can be played");
    try {
        return std::make_shared<const SoundFile>(assets_->read(what, name, sound_endings));
    } catch (const std::invalid_argument& problem) {
        throw property::Error(property::ErrorKind::rejected,
                              what + ": \"" + name + "\" cannot be played: " + problem.what());
    } catch (const property::FileError& problem) {
        throw property::Error(property::ErrorKind::rejected,
                              what + ": " + property::exception_text(problem));
    }
}

}  // namespace fettle::app
