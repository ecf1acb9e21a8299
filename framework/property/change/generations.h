#pragma once
// The generations of changes that one barrier delivers, and the limit of their number.

#include <cstddef>
#include <vector>

#include "queue.h"

namespace fettle::property {

struct Changes;

/// The items that a barrier has delivered. The items of a generation were queued by the handlers of
/// the generation before.
using Generations = std::vector<std::vector<QueueItem>>;

/// After this number of generations a barrier stops with an error, because its handlers may cause
/// changes without end.
inline constexpr std::size_t max_generations = 16;

/// Clears the queue and reports the error: the chain of changes that led to the first undelivered
/// one. Throws the error if the tree has no function for errors of handlers.
void refuse_overrun(Changes& changes, const Generations& generations);

}  // namespace fettle::property
