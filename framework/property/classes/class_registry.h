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
    Class& operator[](std::uint32_t id) { return *classes_[id]; }
    const Class& operator[](std::uint32_t id) const { return *classes_[id]; }
    std::uint32_t size() const { return static_cast<std::uint32_t>(classes_.size()); }
    std::vector<std::string> names() const;

  private:
    void inherit(Class& made);
    void add_property(Class& made, Property property);
    static void pair_events(Class& made);
    static void order_initial(Class& made);
    void check_default(const Class& made, Property& property) const;

    std::vector<std::unique_ptr<Class>> classes_;
    std::unordered_map<std::string, Class*> by_name_;
};

}  // namespace fettle::property
