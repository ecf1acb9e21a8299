#pragma once
// What people use today: bodies in LÖVE, from its own Lua. A process of `love` waits beside the
// benchmark for functions to time, so that both meet the same moments of a noisy machine.

#include <cstdio>
#include <filesystem>
#include <string>

#include <sys/types.h>

namespace fettle::bench {

class Love {
  public:
    /// `functions`: Lua text that defines global functions of a number of rounds, for which `world`
    /// and `ball` (a body of 0.5 m radius in it) are there. Without LÖVE `running` is false.
    explicit Love(const std::string& functions);
    ~Love();
    Love(const Love&) = delete;
    Love& operator=(const Love&) = delete;

    bool running() const { return answers_ != nullptr; }
    /// Processor time of one call, in seconds. Throws std::runtime_error when LÖVE does not answer.
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
