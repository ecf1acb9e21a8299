#include "picture.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <stdexcept>
#include <string>

#include "process.h"

namespace fettle::test {

std::size_t Picture::difference(const Picture& other, unsigned left, unsigned top, unsigned right,
                                unsigned bottom) const {
    if (width != other.width || height != other.height) return std::size_t{width} * height;
    std::size_t count = 0;
    for (unsigned y = top; y < std::min(bottom, height); ++y)
        for (unsigned x = left; x < std::min(right, width); ++x) {
            std::size_t at = (std::size_t{y} * width + x) * 3;
            bool same = rgb[at] == other.rgb[at] && rgb[at + 1] == other.rgb[at + 1] &&
                        rgb[at + 2] == other.rgb[at + 2];
            count += same ? 0 : 1;
        }
    return count;
}

// The header consists of big-endian 32 bit numbers (X11/XWDFile.h); a color map and the rows
// follow.
Picture read_xwd(const std::filesystem::path& file) {
    std::string bytes = read_file(file);
    auto field = [&](std::size_t index) -> std::size_t {
        std::size_t value = 0;
        for (std::size_t i = 0; i < 4; ++i)
            value = value << 8 | static_cast<unsigned char>(bytes.at(index * 4 + i));
        return value;
    };
    constexpr std::size_t header_size = 0, version = 1, width = 4, height = 5, byte_order = 7,
                          bits_per_pixel = 11, bytes_per_line = 12, colors = 19;
    if (bytes.size() < 100 || field(version) != 7 || field(bits_per_pixel) != 32 ||
        field(byte_order) != 0)
        throw std::runtime_error(file.string() + " is not an X window dump of 32 bits a pixel");
    Picture picture;
    picture.width = static_cast<unsigned>(field(width));
    picture.height = static_cast<unsigned>(field(height));
    std::size_t begin = field(header_size) + field(colors) * 12, pitch = field(bytes_per_line);
    if (bytes.size() < begin + pitch * picture.height)
        throw std::runtime_error(file.string() + " is cut off");
    picture.rgb.resize(std::size_t{picture.width} * picture.height * 3);
    std::uint8_t* out = picture.rgb.data();
    for (std::size_t y = 0; y < picture.height; ++y) {
        const char* row = &bytes[begin + y * pitch];
        for (std::size_t x = 0; x < picture.width; ++x, row += 4)
            for (int channel : {2, 1, 0})  // blue comes first
                *out++ = static_cast<std::uint8_t>(row[channel]);
    }
    return picture;
}

// --- PNG, without compression (ISO/IEC 15948; RFC 1950 and 1951 for the stored blocks)

namespace {

void put32(std::string& out, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<char>(value >> shift));
}

std::uint32_t crc(const std::string& bytes) {
    std::uint32_t c = 0xffffffff;
    for (char byte : bytes) {
        c ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) c = (c & 1) != 0 ? 0xedb88320 ^ c >> 1 : c >> 1;
    }
    return ~c;
}

void chunk(std::ofstream& out, const std::string& type, const std::string& data) {
    std::string length, check;
    put32(length, static_cast<std::uint32_t>(data.size()));
    put32(check, crc(type + data));
    out << length << type << data << check;
}

std::string stored(const std::string& raw) {
    constexpr std::size_t largest = 65535;
    std::string out = "\x78\x01";
    std::uint32_t a = 1, b = 0;  // Adler-32
    for (char byte : raw) {
        a = (a + static_cast<unsigned char>(byte)) % 65521;
        b = (b + a) % 65521;
    }
    for (std::size_t at = 0; at < raw.size(); at += largest) {
        std::size_t length = std::min(largest, raw.size() - at);
        out.push_back(at + length == raw.size() ? 1 : 0);
        for (std::size_t value : {length, ~length}) {
            out.push_back(static_cast<char>(value));
            out.push_back(static_cast<char>(value >> 8));
        }
        out.append(raw, at, length);
    }
    put32(out, b << 16 | a);
    return out;
}

}  // namespace

void Picture::save_png(const std::filesystem::path& file) const {
    std::filesystem::create_directories(file.parent_path());
    std::string header, rows;
    put32(header, width);
    put32(header, height);
    header += std::string("\x08\x02\x00\x00\x00", 5);  // 8 bits, RGB
    for (std::size_t y = 0; y < height; ++y) {
        rows.push_back(0);  // no filter
        rows.append(reinterpret_cast<const char*>(&rgb[y * width * 3]), std::size_t{width} * 3);
    }
    std::ofstream out(file, std::ios::binary);
    out << "\x89PNG\r\n\x1a\n";
    chunk(out, "IHDR", header);
    chunk(out, "IDAT", stored(rows));
    chunk(out, "IEND", "");
}

}  // namespace fettle::test
