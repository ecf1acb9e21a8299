#pragma once
// Things due at a moment of simulation time: functions given to `after` and `every`, and coroutines
// in `wait`.

#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

#include "lua_api.h"

namespace fettle::script {

struct Machine;

class Timers {
  public:
    explicit Timers(Machine& machine) : machine_(machine) {}

    /// The function on top of `L`, taken. `interval` below 0: once. Returns the timer's number.
    std::uint64_t add(lua_State* L, double due, double interval);
    /// `L` itself, resumed at `due`.
    void wait(lua_State* L, double due);
    void stop(std::uint64_t id);
    bool active(std::uint64_t id) const { return due_.contains(id); }
    bool waiting(lua_State* thread) const { return waiting_.contains(thread); }
    /// Runs everything due at `now`, in order of time, then of creation. False when one raised.
    bool run(double now);
    void clear();
    std::size_t size() const { return queue_.size(); }

  private:
    struct Timer {
        double interval = -1;
        int reference = LUA_NOREF;  // a function, or a thread that waits
        bool thread = false;
    };
    using Key = std::pair<double, std::uint64_t>;

    bool fire(const Timer& timer);
    int take_thread();

    Machine& machine_;
    std::map<Key, Timer> queue_;
    std::unordered_map<std::uint64_t, double> due_;
    std::unordered_map<lua_State*, std::uint64_t> waiting_;
    std::vector<int> idle_;  // threads that finished, ready for the next function
    std::uint64_t next_id_ = 1;
};

/// `after every wait` into the table of globals on top.
void open_timers(lua_State* L);

}  // namespace fettle::script
