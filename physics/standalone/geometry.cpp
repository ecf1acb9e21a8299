#include <checks/arguments.h>
#include <collision/collide_solids.h>
#include <distance/distance.h>
#include <fettle/physics/geometry.h>
#include <forms/form_access.h>

// Functions on geometries without a world.

namespace fettle::physics {

using namespace detail;

namespace {

PosedForm posed(const Form& form, const char* what, const Pose& pose) {
    return {FormAccess::data(form), check_pose(what, pose)};
}

/// Calls `visit(solid of a, solid of b)` for all pairs of parts.
void for_each_pair(const PosedForm& a, const PosedForm& b, auto&& visit) {
    for (const Solid& of_a : a.solids())
        for (const Solid& of_b : b.solids()) visit(of_a, of_b);
}

}  // namespace

Form::Form(const Geometry& geometry) {
    check(geometry);
    data_ = new detail::SharedForm(form_of(geometry));
}

Form::Form(const Circle& circle) : Form(Geometry(circle)) {}
Form::Form(const Box& box) : Form(Geometry(box)) {}
Form::Form(const Segment& segment) : Form(Geometry(segment)) {}
Form::Form(const Polygon& polygon) : Form(Geometry(polygon)) {}
Form::Form(const Ellipse& ellipse) : Form(Geometry(ellipse)) {}
Form::Form(const Concave& concave) : Form(Geometry(concave)) {}
Form::Form(const Chain& chain) : Form(Geometry(chain)) {}

Form::Form(const Form& other) noexcept : data_(other.data_) {
    data_->forms.fetch_add(1, std::memory_order_relaxed);
}

Form& Form::operator=(Form other) noexcept {
    std::swap(data_, other.data_);
    return *this;
}

Form::~Form() {
    if (data_->forms.fetch_sub(1, std::memory_order_acq_rel) == 1) delete data_;
}

ShapeType Form::type() const {
    return data_->type;
}

std::vector<std::vector<Vec2>> Form::parts() const {
    std::vector<std::vector<Vec2>> all;
    for (const FormPart& part : data_->parts) {
        std::vector<Vec2>& vertices = all.emplace_back();
        for (uint32_t i = 0; i < part.count; ++i)
            vertices.push_back(data_->vertices[part.begin + i]);
    }
    return all;
}

MassProperties mass_properties(const Form& form, float density) {
    check_not_negative("density", density);
    const AreaMoments& moments = FormAccess::data(form).moments;
    return {float(moments.area), float(density * moments.area),
            Vec2(float(moments.center_x), float(moments.center_y)),
            float(density * moments.moment)};
}

Aabb bounding_box(const Form& form, const Pose& pose) {
    const PosedForm at = posed(form, "pose", pose);
    Box4 box = no_box;
    for (const Solid& solid : at.solids()) box = unite(box, box_of(solid));
    return {at.center() + box.low, at.center() + box.high};
}

bool contains(const Form& form, const Pose& pose, const Position& point) {
    const Position p = check_coordinates("point", point);
    const PosedForm at = posed(form, "pose", pose);
    for (const Solid& solid : at.solids())
        if (signed_distance(solid, p - at.center()) <= 0.0f) return true;
    return false;
}

std::optional<SurfaceHit> cast_ray(const Form& form, const Pose& pose, const Position& from,
                                   const Position& to) {
    const Position start = check_coordinates("from", from);
    const Vec2 motion = check_coordinates("to", to) - start;
    const PosedForm at = posed(form, "pose", pose);
    Probe first;
    for (const Solid& solid : at.solids()) {
        const Probe probe = cast_segment(solid, start - at.center(), motion);
        if (probe.fraction < first.fraction) first = probe;
    }
    if (first.fraction > 1.0f) return {};
    return SurfaceHit{start + first.fraction * motion, first.normal, first.fraction};
}

Separation distance(const Form& a, const Pose& pose_a, const Form& b, const Pose& pose_b) {
    const PosedForm at_a = posed(a, "pose_a", pose_a), at_b = posed(b, "pose_b", pose_b);
    Separation nearest;
    nearest.distance = infinity;
    for_each_pair(at_a, at_b, [&](const Solid& of_a, const Solid& of_b) {
        const Nearest found = nearest_points(of_a, of_b, at_b.center() - at_a.center());
        if (found.distance >= nearest.distance) return;
        nearest = {found.distance, at_a.center() + found.on_a, at_a.center() + found.on_b,
                   found.normal};
    });
    return nearest;
}

std::vector<ContactManifold> contact_manifolds(const Form& a, const Pose& pose_a, const Form& b,
                                               const Pose& pose_b, float margin) {
    check_range("margin", margin, 0.0f, 1e6f);
    const PosedForm at_a = posed(a, "pose_a", pose_a), at_b = posed(b, "pose_b", pose_b);
    std::vector<ContactManifold> all;
    for_each_pair(at_a, at_b, [&](const Solid& of_a, const Solid& of_b) {
        Manifold found;
        collide(of_a, of_b, at_b.center() - at_a.center(), margin, false, found);
        if (found.count == 0) return;
        ContactManifold& manifold = all.emplace_back();
        manifold.normal = found.normal;
        manifold.point_count = found.count;
        for (int i = 0; i < found.count; ++i) {
            const detail::ManifoldPoint& point = found.points[i];
            manifold.points[size_t(i)].point = at_a.center() + point.anchor_a;
            manifold.points[size_t(i)].separation = point.separation;
            manifold.points[size_t(i)].feature = uint16_t(point.feature);
        }
    });
    return all;
}

namespace {

/// A movement of a form: the form at its beginning, and the motion of its center.
struct MovingForm {
    PosedForm form;
    Motion motion;
    float extent;

    MovingForm(const Form& moved, const char* what, const Movement& movement)
        : form(FormAccess::data(moved), check_pose(what, "from", movement.from),
               check_point(what, "center", movement.center)),
          extent(form.extent()) {
        const Pose& to = check_pose(what, "to", movement.to);
        const PosedForm end(FormAccess::data(moved), to, movement.center);
        motion.from = form.center();
        motion.velocity = end.center() - form.center();
        motion.turn = to.angle - movement.from.angle;
    }
};

}  // namespace

std::optional<float> time_of_impact(const Form& a, const Movement& movement_a, const Form& b,
                                    const Movement& movement_b) {
    const MovingForm moving_a(a, "movement_a", movement_a), moving_b(b, "movement_b", movement_b);
    constexpr float gap = 1e-4f;
    constexpr int most_searches = 64;
    float first = 1.0f;
    for_each_pair(moving_a.form, moving_b.form, [&](const Solid& of_a, const Solid& of_b) {
        const Sweep sweep_a = {of_a, moving_a.motion, moving_a.extent};
        const Sweep sweep_b = {of_b, moving_b.motion, moving_b.extent};
        // A search ends before the impact where fast rotations pass each other closely; the next
        // one continues from there. The one that starts at the impact stays there.
        float time = -1.0f, next = 0.0f;
        for (int search = 0; search < most_searches && next > time && next < first; ++search) {
            time = next;
            next = detail::time_of_impact(sweep_a, sweep_b, gap, time);
        }
        first = min(first, next);
    });
    if (first < 1.0f) return first;
    return {};
}

std::vector<std::vector<Vec2>> convex_pieces(std::span<const Vec2> outline) {
    return Form(Concave{{outline.begin(), outline.end()}}).parts();
}

}  // namespace fettle::physics
