#include <observed/plot_table.h>

#include <algorithm>
#include <cstdint>

namespace fettle::console {

namespace {

std::string csv_text(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string all = "\"";
    for (const char c : text) c == '"' ? all += "\"\"" : all += c;
    return all + '"';
}

std::string heading(const Trace& trace, const char* component) {
    std::string name = trace.what().text + component;
    if (!trace.what().unit.empty()) name += " [" + trace.what().unit + "]";
    return csv_text(name);
}

}  // namespace

std::string csv_of(const std::vector<Trace>& plots, double dt) {
    std::string table = "step,seconds";
    for (const Trace& trace : plots)
        if (trace.is_vector())
            table += "," + heading(trace, " x") + "," + heading(trace, " y");
        else
            table += "," + heading(trace, "");
    table += "\r\n";
    std::vector<std::size_t> next(plots.size(), 0);
    for (;;) {
        std::int64_t step = INT64_MAX;
        for (std::size_t i = 0; i < plots.size(); ++i)
            if (next[i] < plots[i].samples().size())
                step = std::min(step, plots[i].samples()[next[i]].step);
        if (step == INT64_MAX) return table;
        table += std::to_string(step) + "," + property::number_text(static_cast<double>(step) * dt);
        for (std::size_t i = 0; i < plots.size(); ++i) {
            const auto& samples = plots[i].samples();
            const bool here = next[i] < samples.size() && samples[next[i]].step == step;
            table += "," + (here ? property::number_text(samples[next[i]].x) : std::string());
            if (plots[i].is_vector())
                table += "," + (here ? property::number_text(samples[next[i]].y) : std::string());
            if (here) ++next[i];
        }
        table += "\r\n";
    }
}

}  // namespace fettle::console
