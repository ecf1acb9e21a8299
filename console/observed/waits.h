#pragma once
// Terminals that wait: the next command of a terminal runs when the game is as it was awaited.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/tree.h>
#include <fettle/script/observed.h>

namespace fettle::console {

class Waits {
  public:
    explicit Waits(const property::Tree& tree) : tree_(tree) {}

    /// Seconds from any origin. Without it, the clock of the system is read.
    std::function<double()> clock{};
    /// Whether the game stands because a script failed; optional.
    std::function<bool()> halted{};

    /// `who`: the name of the terminal; "": that of this program, for which a frame takes as long
    /// as a step. A condition that has no value now ends the wait.
    void begin(std::string_view who, script::Wait wait);
    /// Ends it without a result.
    void stop(std::string_view who) { all_.erase(std::string(who)); }
    bool has(std::string_view who) const { return all_.contains(std::string(who)); }
    void after_step();
    void between_frames();
    /// None while the terminal waits. Otherwise the lines that tell how the wait has ended, once.
    std::optional<std::vector<std::string>> result(std::string_view who);

  private:
    struct Waiting {
        script::Wait wait;
        double until = 0;       // s of the clock
        property::Value first;  // of the condition
        std::string problem{};  // why the condition has no value; "" if it has one
        std::optional<std::vector<std::string>> result{};
    };
    double now(std::string_view who) const;
    double step_length() const;  // s
    void check(std::string_view who, Waiting& its) const;
    void check_condition(Waiting& its) const;
    std::string stands() const;
    std::string unmet(const Waiting& its) const;

    const property::Tree& tree_;
    std::map<std::string, Waiting> all_;  // by the terminal
    double passed_ = 0;                   // s, as many as the frames have when each makes one step
};

}  // namespace fettle::console
