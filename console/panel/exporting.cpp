// Plots as files: `export_plot("csv")`, `export_plot("png")`.

#include <utility>

#include <fettle/property/exception_text.h>

#include <look/theme.h>
#include <observed/plot_table.h>
#include <panel/state.h>

namespace fettle::console {

namespace {

constexpr float picture_width = 1200, picture_height = 600;  // px
constexpr float picture_font = 18;

}  // namespace

void Console::State::export_plots() {
    for (const std::string& kind : std::exchange(observing.exports(), {})) {
        show_log();
        try {
            if (observing.plots().empty())
                throw property::Error(property::ErrorKind::rejected,
                                      "export_plot: nothing is plotted");
            const std::string file = kind == "png" ? export_picture() : export_table();
            log.file("wrote ", file);
            if (options.on_result) options.on_result("wrote " + file);
        } catch (const std::exception& error) {
            const std::string problem = property::exception_text(error);
            log.error(problem);
            if (options.on_result) options.on_result("✗ " + problem);
        }
    }
}

std::string Console::State::export_table() {
    if (!options.write_file)
        throw property::Error(property::ErrorKind::rejected,
                              "export_plot: this run writes no files");
    return options.write_file("csv", csv_of(observing.plots(), views.time_bar.times().dt));
}

std::string Console::State::export_picture() {
    if (!options.write_picture)
        throw property::Error(property::ErrorKind::rejected,
                              "export_plot: this run writes no pictures");
    return options.write_picture(picture_width, picture_height,
                                 [this](app::Surface& surface) { draw_plot_alone(surface); });
}

/// A frame with nothing but the plot, on widgets of its own: those of the window keep their sizes
/// and textures.
void Console::State::draw_plot_alone(app::Surface& surface) {
    const float w = surface.width(), h = surface.height();
    {
        ImGuiBackend alone(clipboard);
        PlotView view;
        // The second frame has the sizes that the first one found.
        for (int i = 0; i < 2; ++i) {
            alone.begin_frame(w, h, 0, picture_font);
            draw_part([&] {
                const TimeBar::Times now = views.time_bar.times();
                view.draw(ImVec2(0, h), ImVec2(w, h), h, tree, observing.plots(),
                          {now.step, now.oldest, now.newest, now.dt}, 1);
            });
            alone.end_frame();
        }
        alone.draw(surface);
    }
    ui.activate();
}

}  // namespace fettle::console
