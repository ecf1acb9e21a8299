#pragma once
// LÖVE for comparison: bodies used from its own Lua. A process of `love` runs beside the benchmark
// and times functions on request, so that both are measured under the same load.

#include <cstdio>
#include <filesystem>
#include <string>

#include <sys/types.h>

namespace fettle::bench {

class Love {
  public:
    /// `functions`: Lua text that defines global functions with the number of rounds as their
    /// argument. They may use `world` and `ball`, a body in it with a radius of 0.5 m. Without LÖVE
    /// `running` is false.
    explicit Love(const std::string& functions);
    ~Love();
    Love(const Love&) = delete;
    Love& operator=(const Love&) = delete;

    bool running() const { return answers_ != nullptr; }
    /// Processor time of one call in seconds. Throws std::runtime_error if LÖVE does not answer.
    double seconds(const std::string& function, long long rounds);

  private:
    void write_game(const std::string& functions) const;
    void start();
    void stop();

    std::filesystem::path folder_;
    pid_t process_ = -1;
    std::FILE* requests_ = nullptr;
    std::FILE* answers_ = nullptr;
};

}  // namespace fettle::bench
