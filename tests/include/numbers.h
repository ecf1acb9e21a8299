#pragma once
// Numbers that choose what a test of random calls does.

#include <cstddef>
#include <cstdint>
#include <random>

/// Numbers of a generator with a seed, or of a fuzzer's input, with zeros after its end.
class Numbers {
  public:
    explicit Numbers(std::uint32_t seed) : random_(seed) {}
    Numbers(const std::uint8_t* data, std::size_t size)
        : data_(data), end_(data + size), of_input_(true) {}

    /// Any 64 bits.
    std::uint64_t operator()() {
        if (!of_input_) return random_();
        std::uint64_t number = 0;
        for (int i = 0; i < 8; ++i) number = number << 8 | byte();
        return number;
    }
    /// From 0 to count - 1; takes as few bytes of the input as it can.
    std::uint32_t below(std::uint32_t count) {
        if (!of_input_) return static_cast<std::uint32_t>(random_()) % count;
        if (count <= 256) return byte() % count;
        const std::uint32_t high = byte() << 8 | byte();
        return (count <= 65536 ? high : high << 16 | byte() << 8 | byte()) % count;
    }
    /// Whether the input ended. A generator has no end.
    bool ended() const { return of_input_ && data_ == end_; }

  private:
    std::uint32_t byte() { return data_ == end_ ? 0u : *data_++; }

    std::mt19937_64 random_;
    const std::uint8_t* data_ = nullptr;
    const std::uint8_t* end_ = nullptr;
    bool of_input_ = false;
};
