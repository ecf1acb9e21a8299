#pragma once
// Common parts of all pictures: colors, texts, and the frame of the file.

#include <cstddef>
#include <filesystem>
#include <string>

namespace fettle::bench {

/// The color of the n-th of several series.
const char* color_of(std::size_t series);
/// Escapes text for XML.
std::string escaped(const std::string& text);
/// A complete picture on white; size in pixels.
std::string svg_of_size(int width, int height, const std::string& body);
/// Throws std::runtime_error with the name of the file and the reason if it cannot be written.
void write_svg_text(const std::string& text, const std::filesystem::path& file);

}  // namespace fettle::bench
