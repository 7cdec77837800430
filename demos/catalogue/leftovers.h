// What runs, studies, maps and ledgers left behind, and the golden pictures: found, and copied
// beside the pages, so that the site can be taken anywhere.
#pragma once

#include "demos/ledger/ledger.h"
#include "demos/output/metric_table.h"
#include "demos/stability/map.h"
#include "demos/study/study.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace plait {

class Leftovers {
public:
    using Path = std::filesystem::path;

    // `runs`: out; `golden`: that of the sources; `site`: where copies go.
    Leftovers(Path runs, Path golden, Path site)
        : runs_(std::move(runs)), golden_(std::move(golden)), site_(std::move(site)) {}

    const Path& runs() const { return runs_; }

    // Copies a file to media/NAME unless it is there and no older; its path from the root of the
    // site, "" where there is no such file. Throws FileError.
    std::string copied(const Path& from, const std::string& name) const;

    // Of the scene's run: its clip, a picture out of its middle, and how it was made.
    std::string clip(const std::string& scene) const;
    std::string picture(const std::string& scene) const;  // golden where there was no run
    Settings settings(const std::string& scene) const;    // empty: there was no run
    // Of a knob at a value (films.h): a clip, and a picture out of its middle; "" for none.
    std::string knobClip(const std::string& scene, const std::string& knob,
                         const std::string& value) const;
    std::string knobPicture(const std::string& scene, const std::string& knob,
                            const std::string& value) const;
    // Rows of metrics.csv; none where there was no run or it measured something else.
    std::vector<MetricRow> measured(const std::string& scene,
                                    const std::vector<Metric>& metrics) const;

    // That of the last `ablate`, or the stored one; and its chart where there is one.
    std::optional<Ledger> ledger(const std::string& scene) const;
    std::string ledgerChart(const std::string& scene) const;

    // A chart of a study, and of a map; "" where it never ran. A map that did not is drawn from the
    // boundaries that are stored of it.
    std::string studyChart(const std::string& study) const;
    std::string mapChart(const StabilityMap& map) const;

private:
    std::string middlePicture(const Path& run, const std::string& name) const;

    Path runs_, golden_, site_;
};

}  // namespace plait
