#pragma once
// The classes of a tree, by name and in order of definition.

#include <deque>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include <fettle/property/class.h>

namespace fettle::property {

class ClassRegistry {
  public:
    /// Throws Error(bad_name, unknown_name, wrong_type).
    Class& define(ClassDescriptor descriptor);
    Class* find(std::string_view name) const;
    /// Replaces the properties of a class that a script has defined; see redefinition.h.
    void redefine(Class& of, std::vector<Property> wanted);
    /// Replaces the events of a class that a script has defined; see redefinition.h.
    /// Returns about the memory that they take, which is not freed when they are replaced.
    std::int64_t declare_events(Class& of, std::vector<Event> wanted);
    Class& operator[](std::uint32_t id) { return *classes_[id]; }
    const Class& operator[](std::uint32_t id) const { return *classes_[id]; }
    std::uint32_t size() const { return static_cast<std::uint32_t>(classes_.size()); }
    std::vector<std::string> names() const;
    /// From now on, `require_living` throws for the class and for classes that derive from it.
    void end(const Class& ended) { ended_.push_back(&ended); }
    /// Throws Error(rejected) if the class has ended: its memory does not exist any more.
    void require_living(const Class& of) const;

    // Details of a class that only the tree needs.
    static const std::deque<Property>& own_properties(const Class& of) {
        return of.own_properties_;
    }
    /// `stored`: properties whose values the tree keeps. `observed`: properties that have shadows
    /// while they are watched. `initial`: properties inherited from a native class with another
    /// default in this class.
    static const std::vector<const Property*>& stored(const Class& of) { return of.stored_; }
    static const std::vector<const Property*>& observed(const Class& of) { return of.observed_; }
    static const std::vector<const Property*>& initial(const Class& of) { return of.initial_; }
    /// Estimated memory, with what it copies of its base.
    static std::int64_t weight_of(const Class& of);
    /// Whether all columns of the class were found to have memory.
    static bool& columns_found(const Class& of) { return of.columns_found_; }

  private:
    void inherit(Class& made);
    void add_property(Class& made, Property property);
    static Property::Shortcut shortcut_of(const Property& property);
    std::vector<Class*> with_derived(const Class& of);
    void retire(Class& of, Property& property);
    void add_late(Class& of, Property property);
    void redeclare(Class& of, Property property);
    static void pair_events(Class& made);
    static void order_initial(Class& made);
    void check_default(const Class& made, Property& property) const;

    std::vector<std::unique_ptr<Class>> classes_;
    std::unordered_map<std::string, Class*> by_name_;
    std::vector<const Class*> ended_;
    std::deque<Event> late_events_;  // of classes of scripts, also those declared no more
};

}  // namespace fettle::property
