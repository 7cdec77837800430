#include "points.h"

#include "demos/tools/errors.h"
#include "demos/tools/words.h"
#include "median.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace plait {
namespace {

using Words = std::vector<std::string>;

Words split(const std::string& line, char separator) {
    Words words{""};
    for (const char c : line) {
        if (c == separator)
            words.emplace_back();
        else
            words.back() += c;
    }
    return words;
}

std::string join(const Words& words) {
    std::string line;
    for (const std::string& word : words) line += (line.empty() ? "" : ",") + word;
    return line + "\n";
}

Words columnsOf(const Study& study) {
    Words columns;
    for (const auto& [name, value] : studySettings(study, {})) columns.push_back(name);
    columns.insert(columns.end(), {"repeat", "ending", "evaluations", "seconds[s]", "cpu[s]"});
    for (const ErrorKind& kind : study.errors) columns.push_back(kind.key);
    columns.emplace_back("hash");
    return columns;
}

// A word of a table: without what separates words and lines.
std::string plain(std::string word) {
    std::replace(word.begin(), word.end(), ',', ';');
    std::replace(word.begin(), word.end(), '\n', ' ');
    return word;
}

// True where they are a run of the model as it is now.
bool ofModel(const Study& study, const Settings& model, const Settings& settings) {
    return std::all_of(study.model.begin(), study.model.end(), [&](const auto& shared) {
        return valueOf(model, shared.first) == valueOf(settings, shared.first);
    });
}

StudyPoint pointOf(const std::string& curve, const std::vector<const StudyRow*>& rows) {
    StudyPoint point{.curve = curve, .settings = rows[0]->settings, .ending = rows[0]->ending};
    std::vector<double> seconds, cpu;
    for (const StudyRow* row : rows) {
        seconds.push_back(row->seconds);
        cpu.push_back(row->cpu);
        point.sameBits &= row->hash == rows[0]->hash;
    }
    point.runs = static_cast<int>(rows.size());
    point.seconds = median(seconds);
    point.cpu = median(cpu);
    point.least = *std::min_element(seconds.begin(), seconds.end());
    point.evaluations = static_cast<double>(rows[0]->evaluations);
    point.errors = rows[0]->errors;
    return point;
}

const StudyPoint* defaultOf(const std::vector<StudyPoint>& points) {
    for (const StudyPoint& point : points)
        if (point.isDefault && !point.omitted() && !point.failed()) return &point;
    return nullptr;
}

// The least work at which a curve comes down to the error; infinite where it does not.
double workToReach(double error, const std::vector<const StudyPoint*>& rising) {
    for (std::size_t i = 0; i < rising.size(); ++i) {
        if (rising[i]->errors[0] > error) continue;
        if (i == 0) return rising[0]->evaluations;
        const StudyPoint &before = *rising[i - 1], &after = *rising[i];
        const double part =
            std::log(before.errors[0] / error) / std::log(before.errors[0] / after.errors[0]);
        return before.evaluations * std::pow(after.evaluations / before.evaluations, part);
    }
    return infinity;
}

template <class... Values>
std::string line(const char* format, Values... values) {
    char text[240];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

}  // namespace

std::vector<const StudyPoint*> along(const std::vector<StudyPoint>& points,
                                     const std::string& curve) {
    std::vector<const StudyPoint*> found;
    for (const StudyPoint& point : points)
        if (point.curve == curve && !point.omitted() && !point.failed()) found.push_back(&point);
    std::sort(found.begin(), found.end(),
              [](const auto* a, const auto* b) { return a->evaluations < b->evaluations; });
    return found;
}

std::string csvOf(const Study& study, const std::vector<StudyRow>& rows) {
    std::string csv = join(columnsOf(study));
    for (const StudyRow& row : rows) {
        Words words;
        for (const auto& [name, value] : row.settings) words.push_back(plain(value));
        words.insert(words.end(),
                     {std::to_string(row.repeat), plain(row.ending),
                      std::to_string(row.evaluations), text(row.seconds), text(row.cpu)});
        for (const double error : row.errors) words.push_back(std::isnan(error) ? "" : text(error));
        words.push_back(row.hash);
        csv += join(words);
    }
    return csv;
}

std::vector<StudyRow> rowsFrom(const Study& study, const std::string& csv,
                               const std::string& name) {
    const Words columns = columnsOf(study), lines = split(csv, '\n');
    if (split(lines[0], ',') != columns) throw FileError(name + ": not the columns of this study");
    const std::size_t settings = columns.size() - study.errors.size() - 6;
    std::vector<StudyRow> rows;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        if (lines[i].empty()) continue;
        const Words words = split(lines[i], ',');
        if (words.size() != columns.size())
            throw FileError(name + ": line " + std::to_string(i + 1) + " is not whole");
        StudyRow row;
        std::size_t at = 0;
        for (; at < settings; ++at) row.settings.emplace_back(columns[at], words[at]);
        row.repeat = static_cast<int>(parseInteger(name, words[at++], 1, 1000000));
        row.ending = words[at++];
        row.evaluations = parseInteger(name, words[at++], 0, std::numeric_limits<long>::max());
        row.seconds = parseNumber(name, words[at++], 0, 1e9);
        row.cpu = parseNumber(name, words[at++], 0, 1e9);
        for (std::size_t e = 0; e < study.errors.size(); ++e, ++at)
            row.errors.push_back(words[at].empty() ? std::nan("")
                                 : words[at] == "inf"
                                     ? std::numeric_limits<double>::infinity()
                                     : parseNumber(name, words[at], -1e300, 1e300));
        row.hash = words[at];
        rows.push_back(row);
    }
    return rows;
}

bool StudyPoint::failed() const {
    return ending != "complete" || errors.empty() || !(errors[0] < 2);
}

std::vector<StudyPoint> pointsOf(const Study& study, const std::vector<StudyRow>& rows) {
    std::map<std::string, std::vector<const StudyRow*>> bySettings;
    for (const StudyRow& row : rows) bySettings[textOf(row.settings)].push_back(&row);
    const std::string own = textOf(studySettings(study, {}));
    std::vector<StudyPoint> points;
    const auto take = [&](const std::string& curve, const std::string& settings) {
        const auto found = bySettings.find(settings);
        if (found == bySettings.end()) return;
        points.push_back(pointOf(curve, found->second));
        points.back().isDefault = settings == own;
    };
    std::vector<std::string> taken;
    for (const StudyCurve& curve : study.curves)
        for (const Settings& task : curve.tasks) {
            taken.push_back(textOf(studySettings(study, task)));
            take(curve.name, taken.back());
        }
    for (const std::string& settings : taken) bySettings.erase(settings);
    const Settings model = studySettings(study, {});
    std::vector<std::string> others;
    for (const auto& [settings, of] : bySettings)
        if (ofModel(study, model, of[0]->settings)) others.push_back(settings);
    for (const std::string& settings : others) take("", settings);
    return points;
}

std::string nameOf(const StudyPoint& point) {
    const std::string iterations = valueOf(point.settings, "iterations");
    return valueOf(point.settings, "substeps") + " x " +
           (iterations == "0" ? "importance" : iterations);
}

double defaultExcess(const Study& study, const std::vector<StudyPoint>& points) {
    const StudyPoint* const own = defaultOf(points);
    if (!own) return 0;
    double least = own->evaluations;
    for (const StudyCurve& curve : study.curves)
        if (curve.flaw.empty())
            least = std::min(least, workToReach(own->errors[0], along(points, curve.name)));
    return own->evaluations / least;
}

std::vector<std::string> findings(const Study& study, const std::vector<StudyPoint>& points) {
    std::vector<std::string> lines;
    const StudyPoint* const own = defaultOf(points);
    for (const StudyCurve& curve : study.curves) {
        const std::vector<const StudyPoint*> rising = along(points, curve.name);
        for (std::size_t i = 1; i < rising.size(); ++i) {
            const double before = rising[i - 1]->errors[0], after = rising[i]->errors[0];
            if (after <= 1.1 * before || rising[i]->evaluations == rising[i - 1]->evaluations)
                continue;
            lines.push_back(line("%s: more work is worse, %.2e at %s and %.2e at %s",
                                 curve.name.c_str(), before, nameOf(*rising[i - 1]).c_str(), after,
                                 nameOf(*rising[i]).c_str()));
        }
        if (curve.flaw.empty() || !own) continue;
        const double least = workToReach(own->errors[0], rising) / own->evaluations;
        if (least < 1)
            lines.push_back(line("%s reaches the default's error with %.2f of its work, but %s",
                                 curve.name.c_str(), least, curve.flaw.c_str()));
    }
    for (const StudyPoint& point : points)
        if (!point.sameBits)
            lines.push_back(point.curve + ", " + nameOf(point) + ": runs differ in their bits");
    return lines;
}

}  // namespace plait
