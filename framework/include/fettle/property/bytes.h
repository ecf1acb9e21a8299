#pragma once
// Serialization of state for snapshots, in the byte order of the machine. The reader checks
// everything: data of a wrong size throw, and no count can request more memory than there are
// bytes.

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

/// Types that may be written byte by byte. The types must not contain pointers or references.
template <class T>
concept Bytewise =
    std::is_trivially_copyable_v<T> && !std::is_pointer_v<T> && !std::is_reference_v<T>;

/// Appends values to bytes.
class ByteWriter {
  public:
    explicit ByteWriter(std::vector<std::byte>& out) : out_(&out) {}  ///< which must outlive it

    /// One value, byte by byte.
    template <Bytewise T>
    void put(const T& value) {
        raw(&value, sizeof value);
    }
    /// Writes the count and then the elements.
    template <Bytewise T>
    void put(const std::vector<T>& list) {
        put(std::uint64_t{list.size()});
        raw(list.data(), list.size() * sizeof(T));
    }
    /// Writes the length and then the text.
    void put(std::string_view text);
    void put(const std::string& text) { put(std::string_view(text)); }
    void put(const char* text) { put(std::string_view(text)); }
    /// Writes type and value.
    void put(const Value& value);
    /// Writes these bytes.
    void raw(const void* from, std::size_t size) {
        if (size == 0) return;
        // GCC 12 reports a false overrun for an insertion of bytes (GCC bug 105329).
        const std::size_t at = out_->size();
        out_->resize(at + size);
        std::memcpy(out_->data() + at, from, size);
    }
    /// The bytes written between `begin_block` and `end_block` are a block, with its size in front.
    std::size_t begin_block();
    void end_block(std::size_t begin);  ///< `begin`: what `begin_block` returned
    /// For other formats that append to the bytes.
    std::vector<std::byte>& out() { return *out_; }
    std::size_t size() const { return out_->size(); }  ///< of all bytes

  private:
    std::vector<std::byte>* out_;
};

/// All members throw Error(damaged), e.g. "the saved physics is damaged: it ends too early".
class ByteReader {
  public:
    /// `what`: name of the data, for messages.
    explicit ByteReader(std::span<const std::byte> in, std::string what = "snapshot")
        : in_(in), what_(std::move(what)) {}

    /// One value, byte by byte.
    template <Bytewise T>
    T get() {
        T value;
        raw(static_cast<void*>(&value), 1, sizeof value);
        return value;
    }
    bool boolean() { return get<std::uint8_t>() != 0; }  ///< one byte
    /// A count and then so many elements, as ByteWriter::put wrote them.
    template <Bytewise T>
    std::vector<T> list() {
        const auto count = get<std::uint64_t>();
        if (count > in_.size() / sizeof(T)) ends_too_early();
        std::vector<T> elements(static_cast<std::size_t>(count));
        raw(elements.data(), elements.size(), sizeof(T));
        return elements;
    }
    /// A count of elements of at least `min_size` bytes each.
    std::size_t count(std::size_t min_size = 1);
    std::string_view text();            ///< valid as long as the bytes
    Value value() { return value(0); }  ///< as ByteWriter::put wrote it
    /// The next block, with a reader that cannot read beyond it.
    ByteReader block(std::string what = {});
    std::span<const std::byte> rest() const { return in_; }  ///< bytes that were not read
    bool at_end() const { return in_.empty(); }              ///< whether all bytes were read
    /// Throws unless all bytes were read.
    void finish() const;
    /// Throws with the text `otherwise` unless `holds`.
    void require(bool holds, const char* otherwise) const {
        if (!holds) fail(otherwise);
    }
    [[noreturn]] void fail(const std::string& problem) const;  ///< throws

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

/// A checksum of 64 bits; not secure against forgery.
std::uint64_t checksum(std::span<const std::byte> bytes);

}  // namespace fettle::property

FETTLE_PROPERTY_END
