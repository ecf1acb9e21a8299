#pragma once
// What all pictures have in common: colors, texts, the frame of the file.

#include <cstddef>
#include <filesystem>
#include <string>

namespace fettle::bench {

/// Of the n-th of several series.
const char* color_of(std::size_t series);
/// As text between tags.
std::string escaped(const std::string& text);
/// A whole picture, px, on white.
std::string svg_of_size(int width, int height, const std::string& body);
/// Throws std::runtime_error that names the file and why it cannot be written.
void write_svg_text(const std::string& text, const std::filesystem::path& file);

}  // namespace fettle::bench
