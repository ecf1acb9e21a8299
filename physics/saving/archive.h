#pragma once

#include <saving/fields.h>
#include <saving/words.h>
#include <state/member_list.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

// Serialization of a world. Each type lists its members once: what owns memory in
// `members(io, self)`, records in `fields` (saving/fields.h). The writer and the reader both use
// these lists, so saving and restoring cannot differ.

namespace fettle::physics::detail {

/// Writes the data into blocks of bytes that `Sink` returns: one for each value, or for the
/// elements of a list. If a block is null, its bytes are only counted (`ArchiveSize`).
template <class Sink>
class ArchiveOutput {
  public:
    explicit ArchiveOutput(Sink sink) : sink_(sink) {}

    template <class T>
    void operator()(const T& value) {
        if constexpr (ListsMembers<const T, ArchiveOutput>) {
            T::members(*this, value);
        } else if constexpr (std::is_same_v<T, std::size_t>) {
            const uint64_t size = value;  // also where a size has four bytes
            put(&size, 1);
        } else {
            put(&value, 1);
        }
    }
    template <class T>
    void operator()(const std::vector<T>& list) {
        (*this)(uint64_t{list.size()});
        if constexpr (ListsMembers<const T, ArchiveOutput>)
            for (const T& element : list) (*this)(element);
        else
            put(list.data(), list.size());
    }
    template <class T, std::size_t n>
    void operator()(const std::array<std::vector<T>, n>& lists) {
        each_of(*this, lists);
    }
    void operator()(const Events& events) { event_members(*this, events); }

  private:
    template <class T>
    void put(const T* values, std::size_t count) {
        std::byte* const block = sink_(count * encoded_size<T>());
        if (block == nullptr) return;
        Encoder encode(block);
        for (std::size_t i = 0; i < count; ++i) encode(values[i]);
    }
    Sink sink_;
};

struct AppendBytes {
    std::vector<std::byte>& out;
    std::byte* operator()(std::size_t size) const {
        out.resize(out.size() + size);
        return out.data() + (out.size() - size);
    }
};
struct CountBytes {
    std::size_t& sum;
    std::byte* operator()(std::size_t size) const {
        sum += size;
        return nullptr;
    }
};

class ArchiveWriter : public ArchiveOutput<AppendBytes> {
  public:
    explicit ArchiveWriter(std::vector<std::byte>& out) : ArchiveOutput(AppendBytes{out}) {}
};
/// Counts the bytes that a writer would write, so that memory is allocated once.
class ArchiveSize : public ArchiveOutput<CountBytes> {
  public:
    explicit ArchiveSize(std::size_t& sum) : ArchiveOutput(CountBytes{sum}) {}
};

/// A hash of the sizes of everything that a writer can write: a field that is added or removed
/// makes another format. The values do not count, nor the lengths of lists.
class ArchiveFormat {
  public:
    template <class T>
    void operator()(const T& value) {
        if constexpr (ListsMembers<const T, ArchiveFormat>)
            T::members(*this, value);
        else if constexpr (std::is_same_v<T, std::size_t>)
            add(sizeof(uint64_t));
        else
            add(encoded_size<T>());
    }
    template <class T>
    void operator()(const std::vector<T>&) {
        (*this)(T());
    }
    template <class T, std::size_t n>
    void operator()(const std::array<std::vector<T>, n>& lists) {
        each_of(*this, lists);
    }
    void operator()(const Events& events) { event_members(*this, events); }

    uint32_t hash() const { return hash_; }

  private:
    void add(std::size_t size) { hash_ = (hash_ ^ uint32_t(size)) * 0x01000193u; }
    uint32_t hash_ = 0x811c9dc5u;
};

/// Throws std::invalid_argument if the data end too early, or if a flag is neither 0 nor 1.
class ArchiveReader {
  public:
    explicit ArchiveReader(std::span<const std::byte> in) : in_(in) {}

    template <class T>
    void operator()(T& value) {
        if constexpr (ListsMembers<T, ArchiveReader>) {
            T::members(*this, value);
        } else if constexpr (std::is_same_v<T, std::size_t>) {
            uint64_t size = 0;
            read_values(&size, 1);
            value = std::size_t(size);
        } else {
            read_values(&value, 1);
        }
    }
    template <class T>
    void operator()(std::vector<T>& list) {
        uint64_t count = 0;
        (*this)(count);
        // Every element takes at least one byte, so a count cannot exceed the number of remaining
        // bytes.
        std::size_t least = 1;
        if constexpr (!ListsMembers<T, ArchiveReader>) least = encoded_size<T>();
        if (count > in_.size() / least) throw std::invalid_argument("the bytes end too early");
        list.clear();
        list.resize(std::size_t(count));
        if constexpr (ListsMembers<T, ArchiveReader>)
            for (T& element : list) (*this)(element);
        else
            read_values(list.data(), list.size());
    }
    template <class T, std::size_t n>
    void operator()(std::array<std::vector<T>, n>& lists) {
        each_of(*this, lists);
    }
    void operator()(Events& events) { event_members(*this, events); }
    bool at_end() const { return in_.empty(); }

  private:
    template <class T>
    void read_values(T* values, std::size_t count) {
        const std::size_t size = encoded_size<T>();
        if (in_.size() / size < count) throw std::invalid_argument("the bytes end too early");
        Decoder decode(in_.data());
        for (std::size_t i = 0; i < count; ++i) decode(values[i]);
        in_ = in_.subspan(count * size);
    }
    std::span<const std::byte> in_;
};

}  // namespace fettle::physics::detail
