#include "cells.h"

#include <zlib.h>
#include <zstd.h>

#include <array>
#include <charconv>
#include <string_view>

namespace fettle::maps {
namespace {

using Bytes = std::vector<unsigned char>;

/// Spaces and line ends are skipped.
Bytes from_base64(const Place& place, std::string_view text) {
    static const auto values = [] {
        std::array<std::int16_t, 256> all;
        all.fill(-1);
        constexpr std::string_view digits =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        for (std::size_t i = 0; i < digits.size(); ++i)
            all[static_cast<unsigned char>(digits[i])] = static_cast<std::int16_t>(i);
        return all;
    }();
    Bytes bytes;
    bytes.reserve(text.size() / 4 * 3);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
        if (c == '=') break;
        const int value = values[static_cast<unsigned char>(c)];
        if (value < 0) place.fail("the data are not base64");
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        if ((count += 6) < 8) continue;
        count -= 8;
        bytes.push_back(static_cast<unsigned char>(bits >> count));
    }
    return bytes;
}

/// zlib and gzip. The result has `size` bytes; a file with more is damaged.
Bytes inflated(const Place& place, const Bytes& packed, std::size_t size) {
    Bytes bytes(size);
    z_stream stream{};
    constexpr int zlib_or_gzip = 15 + 32;
    if (inflateInit2(&stream, zlib_or_gzip) != Z_OK) place.fail("out of memory");
    stream.next_in = const_cast<unsigned char*>(packed.data());
    stream.avail_in = static_cast<unsigned>(packed.size());
    stream.next_out = bytes.data();
    stream.avail_out = static_cast<unsigned>(bytes.size());
    const int result = inflate(&stream, Z_FINISH);
    const bool whole = result == Z_STREAM_END && stream.total_out == size;
    inflateEnd(&stream);
    if (!whole) place.fail("the compressed data are damaged, or not as large as the layer");
    return bytes;
}

Bytes from_zstd(const Place& place, const Bytes& packed, std::size_t size) {
    Bytes bytes(size);
    const std::size_t length =
        ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size());
    if (ZSTD_isError(length) || length != size)
        place.fail("the compressed data are damaged, or not as large as the layer");
    return bytes;
}

std::vector<Cell> from_bytes(const Place& place, const std::string& compression,
                             std::size_t count) {
    Bytes bytes = from_base64(place, place.text("data"));
    const std::size_t size = 4 * count;
    if (compression == "zlib" || compression == "gzip")
        bytes = inflated(place, bytes, size);
    else if (compression == "zstd")
        bytes = from_zstd(place, bytes, size);
    else if (!compression.empty())
        place.fail("unknown compression \"" + compression + "\": expected zlib, gzip or zstd");
    if (bytes.size() != size)
        place.fail("expected " + std::to_string(count) + " cells, got " +
                   std::to_string(bytes.size() / 4));
    std::vector<Cell> cells(count);
    for (std::size_t i = 0; i < count; ++i) {
        const unsigned char* const at = bytes.data() + 4 * i;
        cells[i] = cell_of(
            static_cast<std::uint32_t>(at[0]) | static_cast<std::uint32_t>(at[1]) << 8 |
            static_cast<std::uint32_t>(at[2]) << 16 | static_cast<std::uint32_t>(at[3]) << 24);
    }
    return cells;
}

std::vector<Cell> from_csv(const Place& place, const std::string& text) {
    std::vector<Cell> cells;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (at < end) {
        if (*at == ',' || *at == ' ' || *at == '\n' || *at == '\r' || *at == '\t') {
            ++at;
            continue;
        }
        std::uint32_t number = 0;
        const auto [rest, error] = std::from_chars(at, end, number);
        if (error != std::errc()) place.fail("the cells are not a list of numbers");
        cells.push_back(cell_of(number));
        at = rest;
    }
    return cells;
}

std::vector<Cell> from_list(const Place& place) {
    std::vector<Cell> cells;
    const Json& list = place.list("data");
    cells.reserve(list.size());
    for (const Json& number : list) {
        if (!number.is_number_unsigned() || number.get<std::uint64_t>() > UINT32_MAX)
            place.fail("a cell is not a number of a tile: " + number.dump().substr(0, 60));
        cells.push_back(cell_of(number.get<std::uint32_t>()));
    }
    return cells;
}

}  // namespace

Cell cell_of(std::uint32_t number) {
    return {.gid = number & 0x0fffffffu,
            .flip_x = (number & 0x80000000u) != 0,
            .flip_y = (number & 0x40000000u) != 0,
            .flip_diagonal = (number & 0x20000000u) != 0};
}

std::vector<Cell> read_cells(const Place& place, const std::string& encoding,
                             const std::string& compression, int width, int height) {
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (encoding == "base64") return from_bytes(place, compression, count);
    std::vector<Cell> cells;
    if (place.has("data") && place.json["data"].is_string())
        cells = from_csv(place, place.text("data"));
    else
        cells = from_list(place);
    if (cells.size() != count)
        place.fail("expected " + std::to_string(count) + " cells, got " +
                   std::to_string(cells.size()));
    return cells;
}

}  // namespace fettle::maps
