#pragma once
// Operations on all selected instances.

#include <string>
#include <vector>

#include <fettle/property/tree.h>

namespace fettle::console {

/// The instances that are alive, each once and in their order, without those below another one.
std::vector<property::Handle> topmost(const property::Tree& tree,
                                      const std::vector<property::Handle>& instances);
/// Instances whose position in a world is inside the box; not the parts of others, such as the
/// shapes of a body.
std::vector<property::Handle> in_box(const property::Tree& tree, property::Vec2 corner,
                                     property::Vec2 other);
/// All instances of exactly this class.
std::vector<property::Handle> all_of_class(const property::Tree& tree,
                                           const property::Class& wanted);

/// Commands, with the paths of the instances, so that a recording is complete. "" if there are
/// more than `most_in_command`.
constexpr std::size_t most_in_command = 200;
std::string delete_command(const property::Tree& tree,
                           const std::vector<property::Handle>& instances);
std::string clone_command(const property::Tree& tree,
                          const std::vector<property::Handle>& instances);

/// Each call is one step of undo. Instances without a writable `position` are left out.
void move_by(property::Tree& tree, const std::vector<property::Handle>& instances,
             property::Vec2 way);
/// Gives all the mean of their positions, 0: along x, 1: along y.
void align(property::Tree& tree, const std::vector<property::Handle>& instances, int axis);

}  // namespace fettle::console
