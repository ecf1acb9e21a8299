// Where the log is scrolled to.

#include <views/log_view.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fettle::console {

void LogView::scroll(float line_height) {
    if (pages_ != 0) {
        float page = std::max(line_height, ImGui::GetWindowHeight() - 2 * line_height);
        ImGui::SetScrollY(
            std::clamp(ImGui::GetScrollY() + pages_ * page, 0.0f, ImGui::GetScrollMaxY()));
        stick_ = false;
        pages_ = 0;
    } else if (reshaped_to_) {
        ImGui::SetScrollY(*std::exchange(reshaped_to_, std::nullopt));
    } else if (top_line_) {
        const auto row = std::ranges::find(rows_.all(), *top_line_, &LogRow::line);
        ImGui::SetScrollY(static_cast<float>(row - rows_.all().begin()) * line_height);
        top_line_.reset();
        stick_ = false;
    } else {
        follow_output(line_height);
    }
}

/// A view that is at the end follows new output. Of an error that is higher than the view, the
/// message stays in sight.
void LogView::follow_output(float line_height) {
    const bool at_end = ImGui::GetScrollY() >= ImGui::GetScrollMaxY() - 1;
    const bool at_error = held_ && std::fabs(ImGui::GetScrollY() - *held_) < 1;
    const bool fresh = std::exchange(followed_, rows_.wrapped()) != rows_.wrapped();
    if (!std::exchange(stick_, false) && !(fresh && at_error) && !at_end) return;
    if (fresh || !at_error) held_ = fresh ? top_of_high_error(line_height) : std::nullopt;
    if (held_)
        ImGui::SetScrollY(*held_);
    else
        ImGui::SetScrollHereY(1.0f);
}

/// Where the last line begins if it is an error that is higher than the view.
std::optional<float> LogView::top_of_high_error(float line_height) const {
    auto row = rows_.all().end();
    const LogLine* of = nullptr;
    do {
        if (row == rows_.all().begin()) return std::nullopt;
        of = rows_.line((--row)->line);
    } while (of != nullptr && (of->kind == LineKind::source || of->kind == LineKind::caret ||
                               of->kind == LineKind::trace || !row->first));
    const float top = static_cast<float>(row - rows_.all().begin()) * line_height;
    const float high = static_cast<float>(rows_.all().end() - row) * line_height;
    if (of == nullptr || of->kind != LineKind::error || high <= ImGui::GetWindowHeight())
        return std::nullopt;
    return top;
}

/// Where the view is scrolled to when the text, or the room for it, has got another size: the end
/// stays at the end, and elsewhere the topmost line stays. ImGui follows one frame later, and would
/// show rows by their former places until then.
std::optional<float> LogView::place_after_reshaping(float line_height, float height) {
    if (pages_ != 0 || top_line_ || rows_.all().empty()) return std::nullopt;
    const float most =
        std::max(0.0f, static_cast<float>(rows_.all().size()) * line_height - height);
    const bool at_error = held_ && std::fabs(scrolled_ - *held_) < 1;
    if (!at_end_ && !stick_ && !at_error) {
        const auto row = std::ranges::lower_bound(rows_.all(), top_, {}, &LogRow::line);
        return std::min(most, static_cast<float>(row - rows_.all().begin()) * line_height);
    }
    held_ = at_error ? top_of_high_error(line_height) : std::nullopt;
    return held_.value_or(most);
}

}  // namespace fettle::console
