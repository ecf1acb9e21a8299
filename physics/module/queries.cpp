// Methods of World: what is where, what a ray meets.

#include <algorithm>

#include "bindings.h"
#include "classes.h"

namespace fettle::physics_module {
namespace {

using property::Field;
using property::Method;
using property::Record;
using property::Result;
using Arguments = std::span<const Value>;

const Field from{"from", Type::vec2, "m", "Where the ray starts."};
const Field to{"to", Type::vec2, "m", "Where it ends."};
const Field mask{"mask", Type::integer, "", "Categories to look for, as bits; all when left out."};

Field shape_field(std::string name, std::string doc) {
    return {.name = std::move(name),
            .type = Type::reference,
            .doc = std::move(doc),
            .reference_class = "Shape",
            .nullable = true};
}

const std::vector<Field> hit_fields = {
    shape_field("shape", "What was hit; nil for the bounds of the world."),
    {"body", Type::reference, "", "Its body; the world itself for its bounds."},
    {"point", Type::vec2, "m", "Where, in the world."},
    {"normal", Type::vec2, "", "Of the surface there, outward; its length is 1."},
    {"fraction", Type::number, "", "How far along the ray, 0 to 1."},
};
const std::vector<Field> contact_fields = {
    {"body_a", Type::reference, "", "One of the two bodies.", "Body"},
    {"body_b", Type::reference, "", "The other; the world itself for its bounds."},
    shape_field("shape_a", "The shape of body_a."),
    shape_field("shape_b", "The shape of body_b; nil for the bounds."),
    {"point", Type::vec2, "m", "Where, in the world."},
    {"normal", Type::vec2, "", "From a to b; its length is 1."},
    {"separation", Type::number, "m", "Below 0: how deep they overlap."},
    {"force", Type::number, "N", "That presses them apart."},
};

physics::QueryFilter filter(const Value& categories) {
    physics::QueryFilter filter;
    if (!categories.is_nil()) filter.mask = from_value<std::uint64_t>(categories);
    return filter;
}

class Instances {
  public:
    explicit Instances(HostedWorld& hosted) : hosted_(hosted) {}
    Handle of(const physics::Shape& shape) const { return unpack(shape.user_data()); }
    Handle of(const physics::Body& body) const {
        const Handle handle = unpack(body.user_data());
        return handle ? handle : hosted_.self;
    }
    Handle of(physics::ShapeId id) const { return of(hosted_.world.shape(id)); }
    Handle of(physics::BodyId id) const { return of(hosted_.world.body(id)); }

  private:
    HostedWorld& hosted_;
};

Record hit_record(const Instances& instances, const physics::RayHit& hit) {
    return {&hit_fields,
            {instances.of(hit.shape), instances.of(hit.shape.body()), to_value(hit.point),
             to_value(hit.normal), to_value(hit.fraction)}};
}

Result raycast(HostedWorld& hosted, Arguments a) {
    const auto hit = hosted.world.cast_ray(vec2_argument(a[0]), vec2_argument(a[1]), filter(a[2]));
    if (!hit) return Value();
    return hit_record(Instances(hosted), *hit);
}

Result raycast_all(HostedWorld& hosted, Arguments a) {
    std::vector<Record> records;
    for (const physics::RayHit& hit :
         hosted.world.cast_ray_all(vec2_argument(a[0]), vec2_argument(a[1]), filter(a[2])))
        records.push_back(hit_record(Instances(hosted), hit));
    return records;
}

/// The smallest one: what lies in front of a large one is the one meant. Sensors count, so that
/// they can be pointed at too.
Result at(HostedWorld& hosted, Arguments a) {
    physics::QueryFilter all = filter(a[1]);
    all.sensors = true;
    const auto found = hosted.world.query_point(vec2_argument(a[0]), all);
    const auto least = std::min_element(
        found.begin(), found.end(),
        [](const physics::Shape& x, const physics::Shape& y) { return x.area() < y.area(); });
    return found.empty() ? Value() : Value(Instances(hosted).of(least->body()));
}

Result overlap_box(HostedWorld& hosted, Arguments a) {
    const physics::Vec2 p = vec2_argument(a[0]), q = vec2_argument(a[1]);
    physics::QueryFilter all = filter(a[2]);
    all.sensors = true;
    const Instances instances(hosted);
    property::List bodies;
    for (const physics::Shape& shape :
         hosted.world.query_aabb({p.cwiseMin(q), p.cwiseMax(q)}, all)) {
        const Value body(instances.of(shape.body()));
        if (std::find(bodies.begin(), bodies.end(), body) == bodies.end()) bodies.push_back(body);
    }
    return Value(std::move(bodies));
}

Result contacts(HostedWorld& hosted, Arguments) {
    const Instances instances(hosted);
    std::vector<Record> records;
    for (const physics::Contact& contact : hosted.world.contacts()) {
        // The border comes first natively; here it is the second party, so that a is a body.
        const bool swap = contact.body_a.index == 0;
        const auto body_a = swap ? contact.body_b : contact.body_a;
        const auto body_b = swap ? contact.body_a : contact.body_b;
        const auto shape_a = swap ? contact.shape_b : contact.shape_a;
        const auto shape_b = swap ? contact.shape_a : contact.shape_b;
        const physics::Vec2 normal = swap ? physics::Vec2(-contact.normal) : contact.normal;
        float impulses = 0.0f;
        for (int k = 0; k < contact.point_count; ++k)
            impulses += contact.points[static_cast<std::size_t>(k)].normal_impulse;
        for (int k = 0; k < contact.point_count; ++k) {
            const physics::ContactPoint& p = contact.points[static_cast<std::size_t>(k)];
            const float share = impulses > 0.0f ? p.normal_impulse / impulses : 0.0f;
            records.push_back({&contact_fields,
                               {instances.of(body_a), instances.of(body_b), instances.of(shape_a),
                                instances.of(shape_b), to_value(p.point), to_value(normal),
                                to_value(p.separation), to_value(share * contact.normal_force)}});
        }
    }
    return records;
}

template <Result (*Run)(HostedWorld&, Arguments)>
Method method(Hosting& hosting, Method described) {
    described.context = &hosting;
    described.effect = property::Effect::nothing;
    described.call = [](void* context, property::Tree&, Handle, Row row, Arguments arguments) {
        return Run(static_cast<Hosting*>(context)->hosted(row), arguments);
    };
    return described;
}

}  // namespace

std::vector<Method> world_methods(Hosting& hosting) {
    const Field corner{"corner", Type::vec2, "m", "Of the box."};
    const Field opposite{"opposite", Type::vec2, "m", "The corner across."};
    return {
        method<raycast>(hosting, {.name = "raycast",
                                  .parameters = {from, to, mask},
                                  .required = 2,
                                  .returns = hit_fields,
                                  .doc = "The first shape a ray meets, or nil. Sensors do not "
                                         "stop it."}),
        method<raycast_all>(hosting, {.name = "raycast_all",
                                      .parameters = {from, to, mask},
                                      .required = 2,
                                      .returns = hit_fields,
                                      .many = true,
                                      .doc = "Every shape a ray meets, nearest first."}),
        method<at>(hosting, {.name = "at",
                             .parameters = {{"point", Type::vec2, "m", "In the world."}, mask},
                             .required = 1,
                             .returns = {{.name = "body",
                                          .type = Type::reference,
                                          .doc = "The body, or nil.",
                                          .reference_class = "Body",
                                          .nullable = true}},
                             .doc = "The body at a point, that with the smallest shape there "
                                    "where there are several, or nil."}),
        method<overlap_box>(hosting, {.name = "overlap_box",
                                      .parameters = {corner, opposite, mask},
                                      .required = 2,
                                      .returns = {{.name = "bodies",
                                                   .type = Type::list,
                                                   .doc = "Each once, in no special order.",
                                                   .reference_class = "Body",
                                                   .element = Type::reference}},
                                      .doc = "The bodies that reach into a box."}),
        method<contacts>(hosting, {.name = "contacts",
                                   .returns = contact_fields,
                                   .many = true,
                                   .doc = "Every point where two bodies touch now."}),
    };
}

}  // namespace fettle::physics_module
