#pragma once
// Functions of a script that the tree calls at barriers: `watch` and `on`, and the connections that
// end them.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <unordered_map>

#include <fettle/property/question.h>
#include <fettle/property/tree.h>

#include "lua_api.h"

namespace fettle::script {

struct Machine;

/// A function kept alive for a handler. The tree may outlive Lua and so may handlers.
class FunctionRef {
  public:
    /// Takes the function on top of the stack.
    FunctionRef(lua_State* L, Machine& machine);
    ~FunctionRef();
    FunctionRef(const FunctionRef&) = delete;
    void push(lua_State* L) const;
    /// Bytes that it alone keeps, about: `held_memory`, if anybody has asked; else 0.
    std::size_t holds() const { return holds_; }
    void set_holds(std::size_t bytes) { holds_ = bytes; }

  private:
    std::shared_ptr<lua_State*> alive_;
    int reference_;
    std::size_t holds_ = 0;
};

class Subscriptions {
  public:
    explicit Subscriptions(Machine& machine) : machine_(machine) {}
    ~Subscriptions();

    /// Keeps the connection and pushes what a script holds of it.
    void push(lua_State* L, property::Connection connection);
    /// Keeps the connection; no script can stop it.
    void keep(property::Connection connection);
    void stop(std::uint64_t id);
    bool active(std::uint64_t id) const;
    /// Ends all of them: the game is loaded anew.
    void clear();

  private:
    std::uint64_t insert(property::Connection connection);

    Machine& machine_;
    std::unordered_map<std::uint64_t, property::Connection> connections_;
    std::uint64_t next_id_ = 1;
    std::size_t prune_at_ = 256;
};

/// Pushes a connection that stands for a timer.
void push_timer_connection(lua_State* L, std::uint64_t timer);

// Methods of instances and classes.
int subscribe_property(lua_State* L);
int subscribe_event(lua_State* L);

/// Pushes the record handlers of events get.
void push_occurrence(lua_State* L, const property::Occurrence& occurrence);
/// What a handler left in the record, which is on top of the stack, of an event that asks.
void take_answer(lua_State* L, property::Question& question);
void push_existence(lua_State* L, const property::Existence& existence);
/// A handler for `on` over a whole class.
property::Connection connect_event(lua_State* L, Machine& machine, property::Handle instance,
                                   const property::Class& of, const std::string& name,
                                   bool whole_class);

void open_subscriptions(lua_State* L, Machine& machine);
/// `watch` among the globals on top.
void open_watch(lua_State* L);

}  // namespace fettle::script
