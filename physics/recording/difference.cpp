#include <recording/difference.h>
#include <saving/archive.h>

#include <algorithm>

namespace fettle::physics::detail {
namespace {

/// Stands for a difference that has all bytes of the new state.
constexpr uint32_t all_blocks = 0xffffffffu;
/// A run of equal bytes that is shorter than this is written with the changed bytes around it.
constexpr size_t least_gap = 24;

struct BlockSink {
    StateBlocks& to;
    std::byte* operator()(size_t size) const {
        std::byte* const block = AppendBytes{to.bytes}(size);
        to.ends.push_back(to.bytes.size());
        return block;
    }
};

struct Run {
    uint64_t begin, size;

    static void fields(auto& io, auto& s) { io(s.begin, s.size); }
};

/// The runs of bytes of `now` that differ from `before`, or are beyond its end.
std::vector<Run> runs_of(std::span<const std::byte> before, std::span<const std::byte> now) {
    std::vector<Run> runs;
    const size_t common = std::min(before.size(), now.size());
    const auto add = [&](size_t begin, size_t end) {
        if (!runs.empty() && begin < runs.back().begin + runs.back().size + least_gap)
            runs.back().size = end - runs.back().begin;
        else
            runs.push_back({begin, end - begin});
    };
    for (size_t i = 0; i < common;) {
        if (before[i] == now[i]) {
            ++i;
            continue;
        }
        size_t end = i + 1;
        while (end < common && before[end] != now[end]) ++end;
        add(i, end);
        i = end;
    }
    if (common < now.size()) add(common, now.size());
    return runs;
}

void write_block(uint32_t number, std::span<const std::byte> before, std::span<const std::byte> now,
                 ByteWriter& out) {
    const std::vector<Run> runs = runs_of(before, now);
    out.value(number);
    out.value(uint64_t{now.size()});
    out.value(uint32_t(runs.size()));
    for (const Run& run : runs) {
        out.value(run);
        out.bytes(now.data() + run.begin, size_t(run.size));
    }
}

bool equal(std::span<const std::byte> a, std::span<const std::byte> b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size()) == 0);
}

[[noreturn]] void refuse_edits() {
    throw std::invalid_argument("the recording is damaged: its edits do not fit to its world");
}

/// Appends a block, `before` with its changes.
void read_block(std::span<const std::byte> before, ByteReader& in, std::vector<std::byte>& out) {
    const auto size = in.value<uint64_t>();
    const uint32_t runs = in.count(sizeof(Run));
    const size_t begin = out.size();
    out.insert(out.end(), before.begin(),
               before.begin() + std::ptrdiff_t(std::min(uint64_t{before.size()}, size)));
    for (uint32_t i = 0; i < runs; ++i) {
        const auto run = in.value<Run>();
        const auto bytes = in.bytes(run.size);
        const uint64_t there = out.size() - begin;
        // Bytes beyond the old end come in order, without a gap.
        if (run.begin > there || run.size > size || run.begin > size - run.size) refuse_edits();
        if (run.begin + run.size > there) out.resize(begin + size_t(run.begin + run.size));
        std::copy(bytes.begin(), bytes.end(), out.begin() + std::ptrdiff_t(begin + run.begin));
    }
    if (out.size() - begin != size) refuse_edits();
}

}  // namespace

void StateBlocks::read(const WorldState& state) {
    bytes.clear();
    ends.clear();
    ArchiveOutput<BlockSink> write(BlockSink{*this});
    write(state);
}

bool write_difference(const StateBlocks& before, const StateBlocks& now, ByteWriter& out) {
    if (before.ends.size() != now.ends.size()) {
        out.value(uint32_t{1});
        write_block(all_blocks, {}, now.bytes, out);
        return true;
    }
    std::vector<uint32_t> changed;
    for (uint32_t i = 0; i < now.ends.size(); ++i)
        if (!equal(before.block(i), now.block(i))) changed.push_back(i);
    if (changed.empty()) return false;
    out.value(uint32_t(changed.size()));
    for (const uint32_t i : changed) write_block(i, before.block(i), now.block(i), out);
    return true;
}

std::vector<std::byte> apply_difference(const StateBlocks& before, ByteReader& in) {
    std::vector<std::byte> now;
    now.reserve(before.bytes.size());
    const uint32_t changed = in.count(sizeof(uint32_t));
    size_t next = 0;  // block
    const auto copy_to = [&](size_t end) {
        for (; next < end; ++next) {
            const auto block = before.block(next);
            now.insert(now.end(), block.begin(), block.end());
        }
    };
    for (uint32_t i = 0; i < changed; ++i) {
        const auto number = in.value<uint32_t>();
        if (number == all_blocks && changed == 1) {
            read_block({}, in, now);
            next = before.ends.size();
            continue;
        }
        if (number < next || number >= before.ends.size()) refuse_edits();
        copy_to(number);
        read_block(before.block(number), in, now);
        ++next;
    }
    copy_to(before.ends.size());
    return now;
}

}  // namespace fettle::physics::detail
