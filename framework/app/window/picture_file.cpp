// Encodes pictures with stb_image_write, whose code is in this source only. SFML would write them
// into the file itself, and does not notice a full disk.

#include <algorithm>
#include <cctype>
#include <stdexcept>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

#include <fettle/property/storage/replaced_file.h>

#include <window/picture_file.h>

namespace fettle::app {
namespace {

constexpr int jpeg_quality = 90;  // percent

void append(void* to, void* bytes, int count) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(bytes),
                                          static_cast<std::size_t>(count));
}

std::string ending_of(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

/// Empty if it cannot be encoded.
std::string encoded(const Pixels& picture, const std::string& ending) {
    const int width = static_cast<int>(picture.width), height = static_cast<int>(picture.height);
    const void* const rgba = picture.rgba.data();
    std::string bytes;
    bool done = false;
    if (width == 0 || height == 0) return {};
    if (ending == ".png")
        done = stbi_write_png_to_func(append, &bytes, width, height, 4, rgba, 4 * width) != 0;
    else if (ending == ".jpg" || ending == ".jpeg")
        done = stbi_write_jpg_to_func(append, &bytes, width, height, 4, rgba, jpeg_quality) != 0;
    else if (ending == ".bmp")
        done = stbi_write_bmp_to_func(append, &bytes, width, height, 4, rgba) != 0;
    else if (ending == ".tga")
        done = stbi_write_tga_to_func(append, &bytes, width, height, 4, rgba) != 0;
    return done ? bytes : std::string();
}

}  // namespace

void write_picture(const Pixels& picture, const std::filesystem::path& file) {
    std::error_code ignored;
    const std::filesystem::path folder = file.parent_path();
    if (!folder.empty() && !std::filesystem::is_directory(folder, ignored))
        throw std::runtime_error(file.string() + ": cannot be written, since there is no folder " +
                                 folder.string());
    const std::string bytes = encoded(picture, ending_of(file));
    if (bytes.empty())
        throw std::runtime_error(file.string() +
                                 ": the picture cannot be written (endings known: .png .jpg .bmp "
                                 ".tga)");
    property::replace_file(file, bytes);
}

}  // namespace fettle::app
