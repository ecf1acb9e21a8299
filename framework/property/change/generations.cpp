#include "generations.h"

#include <exception>
#include <string>

#include <fettle/property/error.h>
#include <fettle/property/exception_text.h>

#include "changes.h"

namespace fettle::property {

void refuse_overrun(Changes& changes, const Generations& generations) {
    std::string chain;
    const QueueItem* item = &changes.queue.items.front();
    std::size_t part = 0;
    for (std::size_t g = generations.size(); item != nullptr; --g) {
        chain += "\n  " + changes.describe(*item, part);
        part = item->trigger_part;
        item = g == 0 || item->trigger < 0
                   ? nullptr
                   : &generations[g - 1][static_cast<std::size_t>(item->trigger)];
    }
    (void)changes.take_items();
    const Error error(ErrorKind::no_barrier_end,
                      "handlers keep changing what handlers wait for: stopped after " +
                          std::to_string(max_generations) +
                          " rounds; each of these changes caused the one above:" + chain);
    if (!changes.errors.sink) throw error;
    changes.errors.report({.path = "barrier",
                           .where = {},
                           .message = exception_text(error),
                           .exception = std::make_exception_ptr(error)});
}

}  // namespace fettle::property
