#include "report.h"

#include "demos/study/references/reference.h"
#include "demos/tools/files.h"
#include "demos/tools/machine.h"
#include "demos/tools/web_page.h"
#include "demos/tools/words.h"
#include "render/charts/chart.h"
#include "tables.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plait {
namespace {

// What a chart has along x.
struct Cost {
    std::string file, label;
    double (*of)(const StudyPoint&, double seconds);
    double (*ofPeer)(const PeerPoint&);
};

double workOf(const StudyPoint& point, double seconds) { return point.evaluations / seconds; }

const Cost byTime{"", "time of the solve [ms for 1/24 s]", frameCost,
                  [](const PeerPoint& point) { return point.cost; }};
const Cost byWork{"-work", "constraints swept [1/s]", workOf,
                  [](const PeerPoint& point) { return point.evaluations; }};

struct ChartFile {
    std::string file, title;
};

bool shown(const StudyPoint& point, std::size_t error) {
    return !point.failed() && std::isfinite(point.errors[error]) && point.errors[error] > 0;
}

Curve curveOf(const std::string& name, int style, const std::vector<StudyPoint>& points,
              std::size_t error, const Cost& cost, double seconds) {
    Curve curve{.name = name, .style = curveStyle(style)};
    for (const StudyPoint& point : points) {
        if (point.curve != name || point.omitted()) continue;
        const double x = cost.of(point, seconds);
        if (shown(point, error)) {
            if (point.isDefault) curve.highlighted = static_cast<int>(curve.points.size());
            curve.points.push_back({x, point.errors[error]});
        } else if (point.failed() && x > 0) {
            curve.failures.push_back(x);
        }
    }
    if (name.empty()) {
        const std::size_t runs = curve.points.size() + curve.failures.size();
        curve.name = curve.highlighted && runs == 1 ? "the scene's own" : "other settings";
        curve.style.dash = Dash::none;
    }
    return curve;
}

// Markers alone: other engines at settings of their own.
Curve curveOf(const Peer& peer, int style, std::size_t error, const Cost& cost) {
    Curve curve{.name = peer.name, .style = curveStyle(style)};
    curve.style.dash = Dash::none;
    for (const PeerPoint& point : peer.points) {
        const double x = cost.ofPeer(point), y = point.errors[error];
        if (!(x > 0) || std::isnan(y)) continue;
        if (point.errors[0] < 2)
            curve.points.push_back({x, y});
        else
            curve.failures.push_back(x);
    }
    return curve;
}

// False if there is nothing to draw.
bool chartOf(const Study& study, const std::vector<StudyPoint>& points, std::size_t error,
             const Cost& cost, double seconds, Chart& chart) {
    chart.x = {.label = cost.label, .logarithmic = true};
    chart.y = {.label = study.errors[error].label, .logarithmic = true};
    std::vector<std::string> names;
    for (const StudyCurve& curve : study.curves) names.push_back(curve.name);
    names.emplace_back();
    std::vector<ChartPoint> all;
    for (std::size_t i = 0; i < names.size(); ++i) {
        Curve curve = curveOf(names[i], static_cast<int>(i), points, error, cost, seconds);
        all.insert(all.end(), curve.points.begin(), curve.points.end());
        if (!curve.points.empty() || !curve.failures.empty())
            chart.curves.push_back(std::move(curve));
    }
    for (std::size_t i = 0; i < study.peers.size(); ++i) {
        Curve curve = curveOf(study.peers[i], static_cast<int>(names.size() + i), error, cost);
        if (!curve.points.empty() || !curve.failures.empty())
            chart.curves.push_back(std::move(curve));
    }
    if (!all.empty()) chart.front = paretoFront(all);
    return !all.empty();
}

std::vector<ChartFile> writeCharts(const Study& study, const std::vector<StudyPoint>& points,
                                   double seconds, const StudyFolder& folder) {
    std::vector<ChartFile> written;
    const Machine machine = thisMachine();
    char busy[64];
    std::snprintf(busy, sizeof busy, "; wall time was %.2f times this", busyness(points));
    const bool shortened = std::ranges::any_of(study.curves, [](const StudyCurve& curve) {
        return curve.name.find(" x ") != std::string::npos;
    });
    const std::string key = shortened ? "; n x m: n substeps a frame of m iterations" : "";
    for (std::size_t error = 0; error < study.errors.size(); ++error)
        for (const Cost& cost : {byTime, byWork}) {
            if (error > 0 && !cost.file.empty()) continue;
            Figure figure{.title = study.title,
                          .note = (cost.file.empty() ? machine.processor + ", one thread, " +
                                                           machine.kernels + busy
                                                     : "counted work: without noise") +
                                  key,
                          .charts = {Chart{}}};
            if (!chartOf(study, points, error, cost, seconds, figure.charts[0])) continue;
            const std::string file =
                "chart" + (error == 0 ? "" : "-" + study.errors[error].key) + cost.file;
            writeFigure(folder.path() / file, figure);
            written.push_back({file, study.errors[error].label});
        }
    return written;
}

std::string listed(const std::vector<std::string>& lines) {
    std::string html = "<ul>\n";
    for (const std::string& line : lines) html += "<li>" + escaped(line) + "</li>\n";
    return html + "</ul>\n";
}

// Why settings or methods are not in the charts.
std::vector<std::string> omissionsOf(const Study& study, const std::vector<StudyPoint>& points) {
    std::vector<std::string> lines = study.omissions;
    for (const StudyPoint& point : points)
        if (point.omitted()) {
            const std::string line = point.curve + point.ending.substr(point.ending.find(':'));
            if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
        }
    return lines;
}

struct Page {
    std::string reference, command;
    Table cost, error;
    std::vector<std::string> findings, omissions;
    std::vector<ChartFile> charts;
};

std::string pageOf(const Study& study, const Page& page) {
    std::string body = "<p>Reference: " + escaped(page.reference) + "</p>\n";
    for (const ChartFile& chart : page.charts) body += pictureLine(chart.file, chart.title);
    body += "<h2>Equal cost: least error</h2>\n" + htmlOf(page.cost);
    body += "<h2>Equal error: least time and work</h2>\n" + htmlOf(page.error);
    body += "<h2>Findings</h2>\n" + listed(page.findings);
    if (!page.omissions.empty()) body += "<h2>Left out</h2>\n" + listed(page.omissions);
    body +=
        "<h2>How</h2>\n<p>n x m: n substeps a frame of m iterations each. Marks above the top "
        "edge: what diverged, or ended further off than twice the size. The ring: what the scene "
        "itself uses. Pareto front: what no other point beats in both.</p>\n"
        "<p>Every run is a row of <a href=\"points.csv\">points.csv</a>. Time is that of the solve "
        "alone, of one pinned thread, so that what else runs does not count; wall time stands "
        "beside it. The median of all runs with the same settings counts, taken in turns.</p>\n" +
        commandLines(page.command);
    return webPage(study.title, body);
}

std::string wordsOn(double excess) {
    if (excess == 0) return "the default failed, or was not run";
    char words[96];
    std::snprintf(words, sizeof words,
                  "the default does %.2f times the least work that reaches its error", excess);
    return words;
}

}  // namespace

std::string verdictOnReference(const Study& study, const Reference& reference,
                               const std::vector<StudyPoint>& points) {
    if (!study.reference.solve) return "";
    double best = std::numeric_limits<double>::infinity();
    for (const StudyPoint& point : points)
        if (!point.failed()) best = std::min(best, point.errors[0] * study.size);
    if (100 * reference.selfDifference <= best) return "";
    char line[200];
    std::snprintf(line, sizeof line,
                  "THE REFERENCE IS NOT 100 TIMES BETTER THAN THE BEST POINT: %.1e m against %.1e "
                  "m; errors near it are too small or too large",
                  reference.selfDifference, best);
    return line;
}

std::string writeReport(const Study& study, const std::vector<StudyRow>& rows,
                        const Reference& reference, const StudyFolder& folder,
                        const std::string& command) {
    const Run run = studyRun(study, {});
    const double seconds = run.frames() / run.frameRate();
    const std::vector<StudyPoint> points = pointsOf(study, rows);
    Page page{.reference = describe(study, reference),
              .command = command,
              .cost = equalCost(study, points, seconds),
              .error = equalError(study, points, seconds),
              .findings = findings(study, points),
              .omissions = omissionsOf(study, points),
              .charts = {}};
    const std::string verdict = verdictOnReference(study, reference, points);
    if (!verdict.empty()) page.reference += ". " + verdict;
    page.findings.insert(page.findings.begin(), wordsOn(defaultExcess(study, points)));
    writeWhole(folder.path() / "points.csv", csvOf(study, rows));
    page.charts = writeCharts(study, points, seconds, folder);
    writeWhole(folder.path() / "index.html", pageOf(study, page));
    std::string text = "reference: " + page.reference + "\n\n" + textOf(page.cost) + "\n" +
                       textOf(page.error) + "\n";
    for (const std::string& finding : page.findings) text += "finding: " + finding + "\n";
    for (const std::string& omission : page.omissions) text += "left out: " + omission + "\n";
    return text;
}

}  // namespace plait
