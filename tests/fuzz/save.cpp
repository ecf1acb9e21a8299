// Files of saved games: arbitrary bytes, and a valid file with some changed bytes, whose checksum
// may be corrected. The file is refused with a reason or loaded; if the checksum was not corrected,
// the loaded state is the saved one.

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include <unistd.h>

#include <fettle/property/bytes.h>
#include <fettle/property/error.h>
#include <fettle/property/storage/saves.h>

#include "text.h"

using namespace fettle;
namespace fs = std::filesystem;

namespace {

struct Folder {
    fs::path path = fs::temp_directory_path() / ("fettle-fuzz-" + std::to_string(::getpid()));
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
};

const std::vector<std::byte> state(600, std::byte{42});

std::string valid_file(const property::Saves& saves, const fs::path& file) {
    property::Thumbnail picture{.width = 4, .height = 2};
    picture.pixels.assign(32, 7);
    saves.save("slot", 120, state, picture);
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Folder folder;
    static const property::Saves saves(folder.path, "game", "fuzz");
    static const fs::path file = folder.path / "slot.sqlite";
    static const std::string saved = valid_file(saves, file);

    std::string bytes = saved;
    bool forged = false;
    if (size > 0 && data[0] % 4 == 0) {
        bytes.assign(fuzz::text_of(data + 1, size - 1));
    } else {
        for (std::size_t i = 1; i + 2 < size; i += 3)
            bytes[(std::size_t{data[i]} << 8 | data[i + 1]) % bytes.size()] =
                static_cast<char>(data[i + 2]);
        if (size % 3 == 2) bytes.resize(bytes.size() * data[size - 1] / 256);
        forged = size > 0 && data[0] % 4 == 1 && bytes.size() > sizeof(std::uint64_t) * 2;
    }
    if (forged) {  // docs/design/storage.md: the checksum is in the last eight bytes of those
                   // before the last sixteen
        const std::span all(bytes);
        const std::uint64_t checksum =
            property::checksum(std::as_bytes(all.first(all.size() - 2 * sizeof checksum)));
        std::memcpy(&bytes[bytes.size() - sizeof checksum], &checksum, sizeof checksum);
    }
    std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;

    for (const property::SaveInfo& info : saves.list())
        if (info.slot != "slot") std::abort();
    try {
        if (saves.load("slot").state != state && !forged) std::abort();
    } catch (const property::Error&) {
        // damaged, and refused with a reason
    }
    if (!fs::exists(file)) std::abort();
    return 0;
}
