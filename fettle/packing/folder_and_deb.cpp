#include <packing/folder_and_deb.h>

#include <link.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <vector>

#include <fettle/module/trial_program.h>
#include <fettle/property/storage/font_files.h>

#include <files/draft.h>
#include <files/game_path.h>

namespace fettle::program {

namespace fs = std::filesystem;

namespace {

/// As Debian calls the processor for which this program is compiled.
#if defined(__x86_64__)
constexpr std::string_view architecture = "amd64";
#elif defined(__aarch64__)
constexpr std::string_view architecture = "arm64";
#elif defined(__i386__)
constexpr std::string_view architecture = "i386";
#elif defined(__arm__)
constexpr std::string_view architecture = "armhf";
#elif defined(__riscv)
constexpr std::string_view architecture = "riscv64";
#elif defined(__loongarch__)
constexpr std::string_view architecture = "loong64";
#elif defined(__s390x__)
constexpr std::string_view architecture = "s390x";
#elif defined(__powerpc64__)
constexpr std::string_view architecture = "ppc64el";
#else
constexpr std::string_view architecture = "unknown";  // then no system installs the package
#endif

/// The libraries in a package are those of this system, and need its libc or a newer one.
std::string needed_libc() {
    std::array<char, 64> version{};  // "glibc 2.36"
    if (::confstr(_CS_GNU_LIBC_VERSION, version.data(), version.size()) == 0) return "libc6";
    const std::string_view text(version.data());
    const std::size_t blank = text.find(' ');
    return blank == std::string_view::npos
               ? "libc6"
               : "libc6 (>= " + std::string(text.substr(blank + 1)) + ")";
}

constexpr auto executable = fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec |
                            fs::perms::others_read | fs::perms::others_exec;

/// Libraries that every Debian has, or that belong to its display: those of the computer that runs
/// the game fit its drivers.
bool belongs_to_system(const std::string& library) {
    constexpr std::array<std::string_view, 22> names = {
        "ld-linux",  "libc.so",  "libm.so",   "libdl.so",   "libpthread.so", "librt.so",
        "libresolv", "libgcc_s", "libstdc++", "libGL.so",   "libGLX.so",     "libGLdispatch",
        "libOpenGL", "libEGL",   "libX11.so", "libX11-xcb", "libxcb",        "libXau",
        "libXdmcp",  "libdrm",   "libgbm",    "linux-vdso"};
    return std::ranges::any_of(names,
                               [&](std::string_view name) { return library.starts_with(name); });
}

/// The files of the shared libraries that this program runs with, and `others`, without those of
/// the system.
std::vector<fs::path> libraries(const std::vector<fs::path>& others) {
    std::vector<fs::path> all = others;
    dl_iterate_phdr(
        [](dl_phdr_info* info, std::size_t, void* to) {
            static_cast<std::vector<fs::path>*>(to)->emplace_back(info->dlpi_name);
            return 0;
        },
        &all);
    std::erase_if(all, [](const fs::path& file) {
        return !file.has_parent_path() || belongs_to_system(file.filename().string());
    });
    return all;
}

/// The fonts of texts and of the console.
std::vector<fs::path> fonts() {
    std::vector<fs::path> all;
    for (const char* name :
         {"DejaVuSans.ttf", "DejaVuSans-Bold.ttf", "DejaVuSansMono.ttf", "DejaVuSansMono-Bold.ttf"})
        if (const fs::path file = property::font_file(name); !file.empty()) all.push_back(file);
    return all;
}

void write_with_folder(const fs::path& file, const std::string& content) {
    fs::create_directories(file.parent_path());
    write_file(file, content);
}

/// The program that tries out native modules; this one looks for it beside itself.
void copy_trial_program(const fs::path& to) {
    std::error_code error;
    for (const fs::path& place : module::trial_program_places()) {
        if (!fs::is_regular_file(place, error)) continue;
        fs::copy_file(place, to / place.filename());
        fs::permissions(to / place.filename(), executable);
        return;
    }
    throw FileError("modules.json: the program fettle-trial, which tries out modules, is missing");
}

/// Everything but the game's start: the program, its libraries, assets and fonts, and the game.
void copy_all(const fs::path& folder, const ArchiveFiles& files,
              const std::vector<fs::path>& more_libraries) {
    fs::create_directories(folder / "bin");
    fs::create_directories(folder / "lib");
    fs::create_directories(folder / "share/fettle/fonts");
    fs::copy_file("/proc/self/exe", folder / "bin/fettle");
    fs::permissions(folder / "bin/fettle", executable);
    if (files.contains("modules.json")) copy_trial_program(folder / "bin");
    // Libraries are found by their own names, which a link may have.
    for (const fs::path& library : libraries(more_libraries))
        fs::copy_file(fs::canonical(library), folder / "lib" / library.filename(),
                      fs::copy_options::skip_existing);
    for (const fs::path& font : fonts())
        fs::copy_file(font, folder / "share/fettle/fonts" / font.filename());
    if (const fs::path own = assets(); !own.empty())
        fs::copy(own, folder / "share/fettle/assets", fs::copy_options::recursive);
    for (const auto& [name, content] : files) write_with_folder(folder / "game" / name, content);
}

/// The same; a full disk is an error that names the package.
void fill(const fs::path& package, const fs::path& folder, const ArchiveFiles& files,
          const std::vector<fs::path>& more_libraries) {
    try {
        copy_all(folder, files, more_libraries);
    } catch (const fs::filesystem_error& error) {
        throw FileError(package.string() + ": cannot be written: " +
                        reason_of_write(fs::absolute(package).parent_path(), error.code()));
    }
}

/// A shell script that starts the game; `here` is an expression of the shell for the folder.
void write_start(const fs::path& file, const std::string& here) {
    write_with_folder(
        file, "#!/bin/sh\nhere=" + here +
                  "\nexport LD_LIBRARY_PATH=\"$here/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}\""
                  "\nexport FETTLE_FONTS=\"$here/share/fettle/fonts\""
                  "\nexec \"$here/bin/fettle\" run \"$here/game\" --no-reload \"$@\"\n");
    fs::permissions(file, executable);
}

/// Runs a program and waits for it. Throws FileError if it fails.
void run_tool(const std::vector<std::string>& command) {
    std::vector<char*> arguments;
    arguments.reserve(command.size() + 1);
    for (const std::string& each : command) arguments.push_back(const_cast<char*>(each.c_str()));
    arguments.push_back(nullptr);
    pid_t child = 0;
    if (const int problem =
            ::posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ))
        throw FileError(command[0] +
                        " cannot be started, and is needed for this: " + std::strerror(problem));
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (status != 0) throw FileError(command[0] + " failed");
}

/// Refuses a folder, a pipe or a device in the place of a file that is to be made.
void require_place_of_file(const fs::path& to) {
    std::error_code error;
    const fs::file_status status = fs::status(to, error);
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw FileError(to.string() +
                        ": there is something already that is not a file, so "
                        "nothing was made");
}

}  // namespace

std::string start_of_folder(const PackageFacts& facts) {
    constexpr std::array<std::string_view, 4> folders = {"bin", "lib", "share", "game"};
    return std::ranges::find(folders, facts.id) == folders.end() ? facts.id : facts.id + "-start";
}

void make_folder(const fs::path& to, const PackageFacts& facts, const ArchiveFiles& files,
                 const std::vector<fs::path>& more_libraries) {
    const bool packed = to.string().ends_with(".tar.gz");
    std::error_code error;
    if (packed) require_place_of_file(to);
    if (!packed && fs::exists(to, error) && (!fs::is_directory(to) || !fs::is_empty(to)))
        throw FileError(to.string() + ": there is something already, so nothing was made");
    const Draft draft(to);
    const fs::path folder = packed ? draft.path / facts.id : draft.path / "folder";
    fill(to, folder, files, more_libraries);
    write_start(folder / start_of_folder(facts),
                "$(cd \"$(dirname \"$(readlink -f \"$0\")\")\" && pwd)");
    if (packed) {
        const fs::path archive = draft.path / "archive.tar.gz";
        run_tool({"tar", "-czf", archive.string(), "--owner=0", "--group=0", "-C",
                  draft.path.string(), facts.id});
        fs::rename(archive, to);
    } else {
        const fs::path place = to.has_filename() ? to : to.parent_path();
        fs::remove(place, error);
        fs::rename(folder, place);
    }
}

void make_debian_package(const fs::path& to, const PackageFacts& facts, const ArchiveFiles& files,
                         const std::vector<fs::path>& more_libraries) {
    require_place_of_file(to);
    const Draft draft(to);
    const fs::path root = draft.path / "package", made = draft.path / to.filename();
    const std::string place = "/usr/lib/" + facts.id;
    fill(to, root / place.substr(1), files, more_libraries);
    write_start(root / "usr/games" / facts.id, place);
    write_with_folder(root / "usr/share/applications" / (facts.id + ".desktop"),
                      "[Desktop Entry]\nType=Application\nName=" + facts.name +
                          "\nExec=/usr/games/" + facts.id +
                          (facts.icon.empty() ? "" : "\nIcon=" + place + "/game/" + facts.icon) +
                          "\nCategories=Game;\nTerminal=false\n");
    write_with_folder(
        root / "DEBIAN/control",
        "Package: " + facts.id + "\nVersion: " + facts.version +
            "\nArchitecture: " + std::string(architecture) + "\nMaintainer: " + facts.maintainer +
            "\nSection: games\nPriority: optional\n"
            "Depends: " +
            needed_libc() + ", libstdc++6, libgl1, libx11-6, libgl1-mesa-dri\nDescription: " +
            facts.name + "\n A game made with Fettle.\n");
    run_tool({"dpkg-deb", "--build", "--root-owner-group", "-Zgzip", root.string(), made.string()});
    fs::rename(made, to);
}

}  // namespace fettle::program
