#pragma once
// Faults of a file system: no permission, no room.

#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include <unistd.h>

namespace scene_test {

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

  private:
    bool root_;
};

/// Limits the size of files, which has the effect of a full disk.
class SmallFiles {
  public:
    explicit SmallFiles(rlim_t bytes) {
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit less{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &less);
    }
    ~SmallFiles() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    SmallFiles(const SmallFiles&) = delete;

  private:
    rlimit before_{};
    void (*handler_)(int) = nullptr;
};

}  // namespace scene_test
