#pragma once

#include <cstdint>

#include <world/world_data.h>

namespace fettle::physics::detail {

/// True if something may support a dynamic body against gravity: a body that is not dynamic or a
/// joint to the world, reached over contacts and joints; a field; a force of the host. False in
/// free fall. `left_out`: a body that does not count, or `none`.
bool is_supported(const WorldData& data, uint32_t body, uint32_t left_out);

/// The share of its weight (0 … 1) with which a mover of `mass` (kg) loads a dynamic body at a
/// `point`, in the direction `down` of gravity. Where contacts and pins hold the body there, all of
/// it; where it gives way, no more than makes the point fall with the mover. In all cases at most
/// a multiple of what the body itself weighs there: 30 on ground that cannot move, 2 if a
/// field or a force acts on it, otherwise 8. `left_out`: as in `is_supported`.
float weight_share(const WorldData& data, uint32_t body, const Position& point, Vec2 down,
                   float mass, uint32_t left_out);

}  // namespace fettle::physics::detail
