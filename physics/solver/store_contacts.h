#pragma once

#include <contacts/touching.h>
#include <state/step_scratch.h>
#include <threads/pool.h>

namespace fettle::physics::detail {

/// Stores the impulses of the serial contacts (those of wide contacts are stored when their block
/// is solved), and reports touches that begin or end, and hits.
void store_contacts(ContactScratch& contacts, const Touching& touching, float hit_threshold,
                    ThreadPool* threads);

}  // namespace fettle::physics::detail
