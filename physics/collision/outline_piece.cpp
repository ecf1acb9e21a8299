#include <collision/outline_piece.h>

#include <cmath>

namespace fettle::physics::detail {
namespace {

/// A shape may pass several short edges of a hollow in a step, m.
constexpr float hollow_reach = 0.5f;

bool is_zero(Vec2 v) {
    return v.x == 0.0f && v.y == 0.0f;
}

}  // namespace

OutlinePiece::Verdict OutlinePiece::decide(int vertex, Vec2 direction) const {
    const Vec2 d = unrotate(rotation_, direction);
    const Vec2 before = limits_[2 * vertex], after = limits_[2 * vertex + 1];
    // A free end of a chain pushes in all directions except backwards.
    if (is_zero(before) || is_zero(after)) {
        const Vec2 front = is_zero(before) ? after : before;
        return dot(front, d) >= 0.0f ? Verdict::pushes : Verdict::leaves;
    }
    if (cross(before, after) <= flat_angle &&
        !(dot(before, after) < 0.0f && cross(before, after) > -flat_angle))
        return Verdict::flat;
    const bool between = cross(before, d) >= -flat_angle && cross(d, after) >= -flat_angle;
    if (!between || dot(before + after, d) < 0.0f) return Verdict::leaves;
    return is_inner(vertex) ? Verdict::leaves : Verdict::pushes;
}

bool OutlinePiece::continues(int vertex) const {
    return !is_zero(limits_[2 * vertex]) && !is_zero(limits_[2 * vertex + 1]);
}

bool OutlinePiece::is_before_hollow(int edge, Vec2 point, float depth) const {
    const int next = edge + 1 < form.count ? edge + 1 : 0;
    const Vec2 along = form.vertices[next] - form.vertices[edge];
    const float past_begin = dot(point - form.vertices[edge], along),
                past_end = dot(point - form.vertices[next], along);
    const bool before = past_begin < 0.0f;
    if (!before && !(past_end > 0.0f)) return false;
    const float squared = length_squared(along);
    if ((before ? -past_begin : past_end) > max(squared, hollow_reach * std::sqrt(squared)))
        return false;
    const int vertex = before ? edge : next;
    const Vec2 first = limits_[2 * vertex], second = limits_[2 * vertex + 1];
    if (!(cross(first, second) < -flat_angle)) return false;
    const Vec2 normal = rotate(rotation_, before ? first : second);
    return dot(normal, point - form.vertices[vertex]) > -depth;
}

int OutlinePiece::edge_at(int vertex, Vec2 direction) const {
    const int previous = vertex > 0 ? vertex - 1 : form.count - 1;
    int best = -1;
    float most = -2.0f;
    for (int edge : {previous, vertex}) {
        if (is_inner(edge)) continue;
        const float along = dot(form.normals[edge], direction);
        if (along > most) {
            most = along;
            best = edge;
        }
    }
    return best;
}

}  // namespace fettle::physics::detail
