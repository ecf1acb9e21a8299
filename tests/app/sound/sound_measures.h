#pragma once
// Sounds for tests, and what can be measured of a signal.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <sound/mixer.h>

namespace sound_measures {

inline constexpr unsigned rate = fettle::app::Mixer::rate;

/// The bytes of a WAV file with 16 bits a sample; `level(channel, t)` is -1 to 1.
template <class Level>
std::string wave_file(double seconds, unsigned channels, unsigned file_rate, Level level) {
    std::string samples;
    const auto frames = static_cast<std::size_t>(std::lround(seconds * file_rate));
    for (std::size_t i = 0; i < frames; ++i)
        for (unsigned c = 0; c < channels; ++c) {
            const auto value = static_cast<std::int16_t>(
                std::lround(32767 * level(c, static_cast<double>(i) / file_rate)));
            samples.append(reinterpret_cast<const char*>(&value), sizeof value);
        }
    std::string file;
    const auto put = [&](auto number) {
        file.append(reinterpret_cast<const char*>(&number), sizeof number);
    };
    const auto size = static_cast<std::uint32_t>(samples.size());
    file += "RIFF";
    put(std::uint32_t(36 + size));
    file += "WAVEfmt ";
    put(std::uint32_t{16});
    put(std::uint16_t{1});
    put(std::uint16_t(channels));
    put(std::uint32_t(file_rate));
    put(std::uint32_t(file_rate * channels * 2));
    put(std::uint16_t(channels * 2));
    put(std::uint16_t{16});
    file += "data";
    put(size);
    return file + samples;
}

inline double sine(double frequency, double t) {
    return std::sin(2 * std::numbers::pi * frequency * t);
}

inline std::string tone_file(double frequency, double seconds, unsigned file_rate = rate) {
    return wave_file(seconds, 1, file_rate,
                     [&](unsigned, double t) { return 0.5 * sine(frequency, t); });
}

struct Signal {
    std::vector<float> left, right;
    Signal part(double from, double to) const {
        const auto cut = [&](const std::vector<float>& all) {
            const auto at = [&](double t) {
                return all.begin() + std::min(std::ptrdiff_t(t * rate), std::ptrdiff_t(all.size()));
            };
            return std::vector<float>(at(from), at(to));
        };
        return {cut(left), cut(right)};
    }
};

/// The next output of the mixer.
inline Signal mixed(fettle::app::Mixer& mixer, double seconds) {
    Signal all;
    std::vector<std::int16_t> chunk(512);
    while (static_cast<double>(all.left.size()) < seconds * rate) {
        mixer.fill(chunk);
        for (std::size_t i = 0; i < chunk.size(); i += 2) {
            all.left.push_back(static_cast<float>(chunk[i]) / 32767.0f);
            all.right.push_back(static_cast<float>(chunk[i + 1]) / 32767.0f);
        }
    }
    return all;
}

/// Root mean square.
inline double level(std::span<const float> signal) {
    double sum = 0;
    for (const float x : signal) sum += double{x} * double{x};
    return signal.empty() ? 0 : std::sqrt(sum / static_cast<double>(signal.size()));
}

/// From the zero crossings, between the first and the last, Hz.
inline double frequency(std::span<const float> signal, double signal_rate = rate) {
    double first = -1, last = -1;
    int count = 0;
    for (std::size_t i = 1; i < signal.size(); ++i) {
        const float a = signal[i - 1], b = signal[i];
        if (!(a < 0 && b >= 0)) continue;
        last = static_cast<double>(i - 1) + double{-a / (b - a)};
        if (count++ == 0) first = last;
    }
    return count < 2 ? 0 : (count - 1) * signal_rate / (last - first);
}

/// From the first audible sample to the last, s.
inline double length(std::span<const float> signal, double signal_rate = rate) {
    const auto audible = [](float x) { return std::abs(x) > 0.003f; };
    const auto first = std::find_if(signal.begin(), signal.end(), audible);
    const auto last = std::find_if(signal.rbegin(), signal.rend(), audible).base();
    return first == signal.end() ? 0 : static_cast<double>(last - first) / signal_rate;
}

}  // namespace sound_measures
