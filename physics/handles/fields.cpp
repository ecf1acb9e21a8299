#include <checks/arguments.h>
#include <world/world_data.h>

// Handles of fields of force.

namespace fettle::physics {

using namespace detail;

namespace {

struct FieldCheck {
    void operator()(const WindField& f) const {
        check_finite("velocity", f.velocity);
        check_not_negative("density", f.density);
    }
    void operator()(const DragField& f) const {
        check_finite("flow", f.flow);
        check_not_negative("linear", f.linear);
        check_not_negative("quadratic", f.quadratic);
    }
    void operator()(const BuoyancyField& f) const {
        check_finite("level", f.level);
        check_direction("normal", f.normal);
        check_not_negative("density", f.density);
        check_not_negative("drag", f.drag);
        check_finite("flow", f.flow);
    }
    void operator()(const AttractorField& f) const {
        check_coordinates("center", f.center);
        check_finite("strength", f.strength);
        check_count("falloff", f.falloff, 0, 3);
        check_not_negative("core", f.core);
    }
};

}  // namespace

void detail::check(const FieldDef& def) {
    std::visit(FieldCheck{}, def.force);
    if (def.region) check_box("region", *def.region);
}

Field World::create_field(const FieldDef& def) {
    WorldData& data = populate(__func__);
    check(def);
    const FieldDef own = def;  // a copy: a reference into the list of fields would become invalid
    const uint32_t slot = data.field_slots.allocate(data.fields);
    data.fields[slot] = {own, data.self.link->generations.create(), none};
    data.change<detail::wake_all>();
    return {this, {slot, data.fields[slot].generation}};
}

namespace {

bool lives(const WorldData& data, FieldId id) {
    return id.generation != 0 && id.index < data.fields.size() &&
           data.fields[id.index].generation == id.generation;
}

}  // namespace

bool World::is_valid(FieldId id) const {
    return lives(*data_, id);
}

std::vector<Field> World::fields() const {
    std::vector<Field> all;
    for (uint32_t i = 0; i < data_->fields.size(); ++i) {
        if (data_->fields[i].generation != 0)
            all.emplace_back(self(), FieldId{i, data_->fields[i].generation});
    }
    return all;
}

bool Field::is_valid() const noexcept {
    return link_ != nullptr && link_->data != nullptr && lives(*link_->data, id_);
}

WorldData& Field::live() const {
    if (!is_valid()) refuse_dangling("field", link_, id_.index, id_.generation);
    return *link_->data;
}

World& Field::world() const {
    live();
    return *link_->world;
}

const FieldDef& Field::definition() const {
    return live().fields[id_.index].def;
}

void Field::set(const FieldDef& wanted) {
    WorldData& data = live();
    FieldDef& def = data.fields[id_.index].def;
    if (wanted.user_data != def.user_data || wanted.force.index() != def.force.index())
        data.self.may_populate("Field", __func__);
    else
        data.self.may_edit("Field", __func__);
    check(wanted);
    def = wanted;
    data.change<detail::wake_all>();
}

void Field::destroy() {
    WorldData& data = live();
    data.self.may_populate("Field", __func__);
    data.field_slots.release(data.fields, id_.index);
    data.change<detail::wake_all>();
}

}  // namespace fettle::physics
