#pragma once

#include <geometry/make_room.h>
#include <geometry/vector.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace fettle::physics::detail {

/// Vertices of all shapes in contiguous arrays. They are in blocks whose sizes are powers of two
/// and which are reused. A shape stores the beginning of its block. The arrays contain body
/// coordinates, and the same coordinates rotated about the body's center of mass.
struct VertexPool {
    std::vector<Vec2> local;       ///< body coordinates
    std::vector<Vec2> normals;     ///< outward normal of the edge from i to i+1, body coordinates
    std::vector<Vec2> vertices;    ///< rotated, relative to the center of mass
    std::vector<Vec2> directions;  ///< rotated normals
    std::vector<float> offsets;    ///< directions·vertices: does not change with rotation

    static uint32_t capacity_for(uint32_t count) { return std::bit_ceil(count < 1 ? 1u : count); }

    uint32_t allocate(uint32_t capacity) {
        auto& bin = free_[size_t(std::countr_zero(capacity))];
        if (!bin.empty()) {
            const uint32_t begin = bin.back();
            bin.pop_back();
            clear_rotated(begin, capacity);
            return begin;
        }
        const uint32_t begin = uint32_t(local.size());
        const size_t size = local.size() + capacity;
        make_room_for(capacity);
        local.resize(size);
        normals.resize(size);
        vertices.resize(size);
        directions.resize(size);
        offsets.resize(size);
        return begin;
    }
    /// Clears the rotated data of a block. A shape without a body has none, and those of an earlier
    /// shape may be too large to be saved and restored.
    void clear_rotated(uint32_t begin, uint32_t capacity) {
        std::fill_n(vertices.begin() + begin, capacity, Vec2{});
        std::fill_n(directions.begin() + begin, capacity, Vec2{});
        std::fill_n(offsets.begin() + begin, capacity, 0.0f);
    }
    /// Throws std::bad_alloc if there is no memory; then no size has changed.
    void make_room_for(uint32_t capacity) {
        make_room(local, capacity), make_room(normals, capacity), make_room(vertices, capacity);
        make_room(directions, capacity), make_room(offsets, capacity);
    }
    void release(uint32_t begin, uint32_t capacity) {
        if (capacity > 0) free_[size_t(std::countr_zero(capacity))].push_back(begin);
    }

    /// For code that processes four vertices at a time: repeats the first vertex, with an edge
    /// offset so large that the edge never separates shapes.
    void pad_triangle(uint32_t begin) {
        vertices[begin + 3] = vertices[begin];
        directions[begin + 3] = directions[begin];
        offsets[begin + 3] = 1e30f;
    }

    /// False if deserialized data are damaged. If true, the free blocks of each size are inside the
    /// pool.
    bool is_walkable() const {
        const size_t size = local.size();
        for (const size_t other :
             {normals.size(), vertices.size(), directions.size(), offsets.size()})
            if (other != size) return false;
        for (size_t power = 0; power < free_.size(); ++power)
            for (const uint32_t begin : free_[power])
                if (size < (size_t{1} << power) || begin > size - (size_t{1} << power))
                    return false;
        return true;
    }

    /// Visits the free blocks: their beginning and size.
    void for_each_free(auto&& visit) const {
        for (size_t power = 0; power < free_.size(); ++power)
            for (const uint32_t begin : free_[power]) visit(size_t{begin}, size_t{1} << power);
    }

    /// For saving and restoring.
    static void members(auto& io, auto& self) {
        io(self.local), io(self.normals), io(self.vertices), io(self.directions);
        io(self.offsets), io(self.free_);
    }

  private:
    std::array<std::vector<uint32_t>, 32> free_;  // by power of two
};

}  // namespace fettle::physics::detail
