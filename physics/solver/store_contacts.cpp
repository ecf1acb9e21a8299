#include <contacts/reports.h>
#include <solver/serial_contacts.h>

#include <bit>

namespace fettle::physics::detail {
namespace {

/// Reports the news of the wide contacts in the order of the acting contacts, not of the colors.
void report_wide(ContactScratch& scratch, const Touching& touching, float hit_threshold,
                 ThreadPool* threads) {
    const std::vector<GroupNews>& news = scratch.news;
    std::vector<uint64_t>& told = scratch.told;
    told.assign((scratch.acting.size() + 63) / 64, 0);
    for (size_t group = 0; group < news.size(); ++group) {
        for (uint32_t left = news[group].told; left != 0; left &= left - 1) {
            const uint32_t i =
                scratch.lane_contacts[group * lanes + size_t(std::countr_zero(left))];
            told[i / 64] |= uint64_t{1} << i % 64;
        }
    }
    bool any_hits = false;
    for (size_t word = 0; word < told.size(); ++word) {
        for (uint64_t left = told[word]; left != 0; left &= left - 1) {
            const ActingContact& c = scratch.acting[word * 64 + size_t(std::countr_zero(left))];
            const bool touches = (news[c.place / lanes].touches >> c.place % lanes & 1) != 0;
            if (touches != c.touching()) set_touching(touching, c.slot, touches);
            any_hits |= c.hit_events();
        }
    }
    if (any_hits)
        report_wide_hits(touching.objects, touching.columns, hit_threshold, scratch, threads,
                         touching.events);
}

}  // namespace

void store_contacts(ContactScratch& contacts, const Touching& touching, float hit_threshold,
                    ThreadPool* threads) {
    report_wide(contacts, touching, hit_threshold, threads);
    store_serial(contacts, touching, hit_threshold, threads);
}

}  // namespace fettle::physics::detail
