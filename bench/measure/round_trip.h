#pragma once
// The communication time between processors.

namespace fettle::bench {

/// Nanoseconds for sending a word from one thread to another and back; the best of several tries.
/// About 50 if both threads run on one core (hyper-threading), about 100 if their cores share a
/// cache, several hundred otherwise; thousands if no second processor is free at the moment.
double round_trip_ns();

}  // namespace fettle::bench
