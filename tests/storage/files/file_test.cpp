// Files: replaced completely or not at all, whatever fails.

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "catch.h"
#include "scene_world.h"
#include "temporary_folder.h"

namespace file_test {

using namespace scene_test;
namespace fs = std::filesystem;

namespace {

class Folder : public TemporaryFolder {
  public:
    std::size_t entries() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(path), fs::directory_iterator()));
    }
};

std::string content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream all;
    all << in.rdbuf();
    return all.str();
}

std::string refusal(const SceneWorld& w, Handle node, const fs::path& file) {
    try {
        save_scene(w.tree, node, file);
    } catch (const FileError& e) {
        CHECK(e.file() == file);
        return e.what();
    }
    return "";
}

/// Switches to a user without permissions if the tests run as root.
class Nobody {
  public:
    Nobody() : root_(::geteuid() == 0) {
        if (root_ && ::seteuid(65534) != 0) throw std::runtime_error("cannot become nobody");
    }
    ~Nobody() {
        if (root_ && ::seteuid(0) != 0) std::abort();
    }
    Nobody(const Nobody&) = delete;
    Nobody& operator=(const Nobody&) = delete;

  private:
    bool root_;
};

}  // namespace

TEST_CASE("a scene is saved to a file and loaded from it") {
    SceneWorld w;
    const Folder folder;
    const fs::path file = folder.path / "level one.json";
    const Handle thing = w.add("Thing", "ball");
    w.tree.set(thing, "number", -2);
    save_scene(w.tree, thing, file);
    CHECK(content(file) == scene_text(w.tree, thing));
    const Handle copy = load_scene(w.tree, file, w.world, "copy");
    CHECK(w.tree.path(copy) == "world.copy");
    CHECK(w.tree.get(copy, "number") == Value(-2.0));
    CHECK(folder.entries() == 1);
}

TEST_CASE("saving again replaces the file and keeps its permissions and links") {
    SceneWorld w;
    const Folder folder;
    const fs::path file = folder.path / "level.json";
    const fs::path link = folder.path / "link.json";
    const Handle thing = w.add("Thing", "ball");
    save_scene(w.tree, thing, file);
    fs::permissions(file, fs::perms(0640));
    fs::create_symlink("level.json", link);
    w.tree.set(thing, "number", 7);
    save_scene(w.tree, thing, link);
    CHECK(fs::is_symlink(link));
    CHECK(content(file) == scene_text(w.tree, thing));
    CHECK((fs::status(file).permissions() & fs::perms::mask) == fs::perms(0640));
    CHECK(folder.entries() == 2);
}

TEST_CASE("a file that cannot be read is reported with the reason") {
    SceneWorld w;
    const Folder folder;
    const auto message = [&](const fs::path& file) -> std::string {
        try {
            load_scene(w.tree, file, w.world);
        } catch (const FileError& e) {
            return e.what();
        }
        return "";
    };
    const fs::path missing = folder.path / "missing.json";
    CHECK(message(missing) == missing.string() + ": could not be read: No such file or directory");
    CHECK(message(folder.path).find("it is a folder") != std::string::npos);
    CHECK(message("/dev/zero").find("not a regular file") != std::string::npos);
    const fs::path pipe = folder.path / "pipe";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    CHECK(message(pipe).find("not a regular file") != std::string::npos);
    const fs::path big = folder.path / "big.json";
    std::ofstream(big) << " ";
    fs::resize_file(big, std::uintmax_t{1} << 30);
    CHECK(message(big).find("larger than 64 MB") != std::string::npos);
}

TEST_CASE("errors in a file name it as the caller did") {
    SceneWorld w;
    const Folder folder;
    const fs::path file = folder.path / "bad.json";
    std::ofstream(file) << "{\n  oops\n}";
    try {
        load_scene(w.tree, file, w.world);
        FAIL("nothing was refused");
    } catch (const SceneError& e) {
        CHECK(std::string(e.what()).find(file.string() + ":2:3: not JSON") == 0);
    }
}

TEST_CASE("a place that cannot be written to is reported with the reason") {
    SceneWorld w;
    const Folder folder;
    const Handle thing = w.add("Thing", "ball");
    const fs::path file = folder.path / "level.json";
    save_scene(w.tree, thing, file);
    CHECK(refusal(w, thing, file / "below.json").find("Not a directory") != std::string::npos);
    CHECK(
        refusal(w, thing, folder.path / "gone" / "level.json").find("No such file or directory") !=
        std::string::npos);
    CHECK(refusal(w, thing, folder.path).find("it is a folder") != std::string::npos);
    CHECK(refusal(w, thing, "/dev/null").find("not a regular file") != std::string::npos);
    CHECK(fs::is_character_file("/dev/null"));
    fs::create_symlink("nowhere", folder.path / "dangling");
    CHECK(refusal(w, thing, folder.path / "dangling").find("it is a link") != std::string::npos);
    CHECK(refusal(w, thing, folder.path / std::string(300, 'x')).find("too long") !=
          std::string::npos);
    CHECK(folder.entries() == 2);
}

TEST_CASE("a read-only folder or file leaves the old file unchanged") {
    SceneWorld w;
    const Folder folder;
    const fs::path file = folder.path / "level.json";
    const Handle thing = w.add("Thing", "ball");
    save_scene(w.tree, thing, file);
    const std::string before = content(file);
    w.tree.set(thing, "number", 5);
    fs::permissions(folder.path, fs::perms(0555));
    {
        const Nobody nobody;
        CHECK(refusal(w, thing, file).find("Permission denied") != std::string::npos);
        CHECK(refusal(w, thing, folder.path / "new.json").find("Permission denied") !=
              std::string::npos);
    }
    fs::permissions(folder.path, fs::perms(0777));
    fs::permissions(file, fs::perms(0444));
    {
        const Nobody nobody;  // may write to the folder, so only the mode of the file forbids it
        CHECK(refusal(w, thing, file).find("could not be written") != std::string::npos);
    }
    CHECK(content(file) == before);
    CHECK(folder.entries() == 1);
}

TEST_CASE("a full disk leaves the old file unchanged") {
    SceneWorld w;
    const Folder folder;
    const fs::path file = folder.path / "level.json";
    const Handle note = w.add("Note", "note");
    save_scene(w.tree, note, file);
    const std::string before = content(file);
    w.tree.set(note, "text", std::string(200'000, 'x'));

    // Files are limited to 64 kB: a write fails as on a full disk, after some data are written.
    // This is done in another process, since the limit would also stop the output of the test.
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        ::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{65536, 65536};
        if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) ::_exit(3);
        try {
            save_scene(w.tree, note, file);
        } catch (const FileError& e) {
            ::_exit(std::string(e.what()).find("File too large") != std::string::npos ? 0 : 1);
        } catch (...) {
        }
        ::_exit(2);
    }
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
    CHECK(content(file) == before);
    CHECK(folder.entries() == 1);
}

TEST_CASE("a process killed while saving leaves the complete old or new file") {
    SceneWorld w;
    const Folder folder;
    const fs::path file = folder.path / "level.json";
    const Handle note = w.add("Note", "note");
    std::vector<std::string> versions;
    for (const char letter : {'a', 'b'}) {
        w.tree.set(note, "text", std::string(300'000, letter));
        versions.push_back(w.text(note));
    }
    save_scene(w.tree, note, file);
    for (int round = 0; round < 20; ++round) {
        int ready[2];
        REQUIRE(::pipe(ready) == 0);
        const pid_t child = ::fork();
        REQUIRE(child >= 0);
        if (child == 0) {
            try {
                for (int i = 0;; ++i) {
                    w.tree.set(note, "text", std::string(300'000, "ab"[i % 2]));
                    save_scene(w.tree, note, file);
                    if (i == round && ::write(ready[1], "x", 1) != 1) ::_exit(1);
                }
            } catch (...) {
                ::_exit(2);
            }
        }
        ::close(ready[1]);
        char byte = 0;
        CHECK(::read(ready[0], &byte, 1) == 1);
        ::close(ready[0]);
        ::usleep(static_cast<useconds_t>(round * 137));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        const std::string found = content(file);
        CHECK((found == versions[0] || found == versions[1]));
    }
}

}  // namespace file_test
