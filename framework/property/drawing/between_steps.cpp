#include <fettle/property/between_steps.h>

#include <tree/state.h>

namespace fettle::property {

namespace {

/// Calls `visit(columns)` for the columns of each class whose instances have places.
template <class Visit>
void each_placed_class(Tree::State& s, Visit visit) {
    for (const auto& columns : s.instances.stored)
        if (columns != nullptr && columns->places.any()) visit(*columns);
}

}  // namespace

void note_step_begins(Tree& tree) {
    Tree::State& s = tree.state();
    each_placed_class(s, [](StoredColumns& c) { c.places.note_step_begins(c); });
    s.instances.ad_hoc.note_step_begins();
    ++s.noted.begun;
    s.noted.running = true;
}

void note_step_ended(Tree& tree, const FarMoves& far) {
    Tree::State& s = tree.state();
    each_placed_class(s, [](StoredColumns& c) { c.places.note_step_ended(c); });
    s.instances.ad_hoc.note_step_ended();
    s.noted.far = far;
    s.noted.running = false;
}

void note_step_left(Tree& tree) {
    tree.state().noted.running = false;
}

const NotedSteps& noted_steps(const Tree& tree) {
    return tree.state().noted;
}

Value drawn_points(const Tree& tree, Handle instance, const Property& points, bool on_screen,
                   double alpha) {
    const Tree::State& s = tree.state();
    const Node& node = s.instances.require(instance, points);
    const StoredColumns* const columns = s.instances.stored[node.class_id].get();
    if (columns == nullptr || !columns->places.has_points()) return tree.peek(instance, points);
    return columns->places.drawn_points(*columns, node.stored_row, alpha,
                                        on_screen ? s.noted.far.screen : s.noted.far.world);
}

}  // namespace fettle::property
