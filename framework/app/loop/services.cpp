#include <fettle/app/services.h>

namespace fettle::app {

using property::Native;
using property::Type;

namespace {

void define_audio(property::Tree& tree, Audio& audio) {
    const property::Class& audio_class = tree.define(
        {.name = "Audio",
         .doc = "Everything that is heard.",
         .creatable = false,
         .properties = {
             {.name = "volume",
              .type = Type::number,
              .default_value = 1.0,
              .range = {0, 1},
              .doc = "Loudness of everything, 1 being that of the recordings.",
              .binding = column(audio, Native::f64, 0, [](Audio& a) { return &a.volume; })},
             {.name = "muted",
              .type = Type::boolean,
              .default_value = false,
              .doc = "Silences everything and leaves the volume as it is.",
              .binding = column(audio, Native::boolean, 0, [](Audio& a) { return &a.muted; })}}});
    tree.create(audio_class, tree.root(), "audio");
}

}  // namespace

// Input must be last, because it uses the view.
Services::Services(property::Tree& tree) : input(define(tree), view), tree_(tree) {
    tree.add_part(clock_part_);
}

Services::~Services() {
    tree_.remove_part(clock_part_);
}

property::Tree& Services::define(property::Tree& tree) {
    define_clock(tree, clock);
    define_view(tree, view);
    define_audio(tree, audio);
    return tree;
}

}  // namespace fettle::app
