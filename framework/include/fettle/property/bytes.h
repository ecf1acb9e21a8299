#pragma once
// Bytes: how state is written down for snapshots and read again, in the byte order of the machine.
// Reading trusts nothing: whatever does not fit throws, and no count can ask for more memory than
// there are bytes.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <fettle/property/export.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// What may be written byte by byte. Not `is_trivially_copyable`, which Eigen's vectors are not;
/// whoever owns memory has a destructor that does something. References must not be in it.
template <class T>
concept Bytewise =
    std::is_trivially_destructible_v<T> && !std::is_pointer_v<T> && !std::is_reference_v<T>;

class ByteWriter {
  public:
    explicit ByteWriter(std::vector<std::byte>& out) : out_(&out) {}

    template <Bytewise T>
    void put(const T& value) {
        raw(&value, sizeof value);
    }
    /// As a count and its elements.
    template <Bytewise T>
    void put(const std::vector<T>& list) {
        put(std::uint64_t{list.size()});
        raw(list.data(), list.size() * sizeof(T));
    }
    void put(std::string_view text);
    void put(const std::string& text) { put(std::string_view(text)); }
    void put(const char* text) { put(std::string_view(text)); }
    void put(const Value& value);
    void raw(const void* from, std::size_t size) {
        if (size == 0) return;
        // GCC 12 takes an insertion of bytes for an overrun (its bug 105329).
        const std::size_t at = out_->size();
        out_->resize(at + size);
        std::memcpy(out_->data() + at, from, size);
    }
    /// What is written between the two is a block of its own, with its size in front.
    std::size_t begin_block();
    void end_block(std::size_t begin);
    /// For formats of others that append for themselves.
    std::vector<std::byte>& out() { return *out_; }
    std::size_t size() const { return out_->size(); }

  private:
    std::vector<std::byte>* out_;
};

/// All of it throws Error(damaged): "the saved physics is damaged: it ends too early".
class ByteReader {
  public:
    /// `what` is read, for messages.
    explicit ByteReader(std::span<const std::byte> in, std::string what = "snapshot")
        : in_(in), what_(std::move(what)) {}

    template <Bytewise T>
    T get() {
        T value;
        raw(static_cast<void*>(&value), 1, sizeof value);
        return value;
    }
    bool boolean() { return get<std::uint8_t>() != 0; }
    template <Bytewise T>
    std::vector<T> list() {
        const auto count = get<std::uint64_t>();
        if (count > in_.size() / sizeof(T)) ends_too_early();
        std::vector<T> elements(static_cast<std::size_t>(count));
        raw(elements.data(), elements.size(), sizeof(T));
        return elements;
    }
    /// Of things that take at least `least` bytes each.
    std::size_t count(std::size_t least = 1);
    std::string_view text();
    Value value() { return value(0); }
    /// The next block; reading it cannot leave it.
    ByteReader block(std::string what = {});
    std::span<const std::byte> rest() const { return in_; }
    bool at_end() const { return in_.empty(); }
    /// Throws unless everything was read.
    void finish() const;
    void require(bool holds, const char* otherwise) const {
        if (!holds) fail(otherwise);
    }
    [[noreturn]] void fail(const std::string& problem) const;

  private:
    void raw(void* to, std::size_t count, std::size_t size) {
        if (in_.size() / size < count) ends_too_early();
        if (count > 0) std::memcpy(to, in_.data(), count * size);
        in_ = in_.subspan(count * size);
    }
    Value value(int depth);
    [[noreturn]] void ends_too_early() const;

    std::span<const std::byte> in_;
    std::string what_;
};

/// A checksum of 64 bits; not against forgers.
std::uint64_t checksum(std::span<const std::byte> bytes);

}  // namespace fettle::property

FETTLE_PROPERTY_END
