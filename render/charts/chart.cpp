#include "chart.h"

#include "parts.h"
#include "render/pictures/image.h"
#include "render/pictures/whole_file.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plait {
namespace {

constexpr double margin = 36;

// Wide pages are seen smaller: their text grows, though less than they do.
double textSize(const Figure& figure) { return std::max(1.0, std::sqrt(figure.width / 1280.0)); }

// The room that the longest of the charts' own legends takes.
double legendHeight(const Figure& figure) {
    std::size_t most = 0;
    for (const Chart& chart : figure.charts)
        most = std::max(most, legendEntries({&chart, 1}).size());
    return figure.legendBelow ? 10 + textSize(figure) * legendPitch * static_cast<double>(most) : 0;
}

// Charts in rows from the left.
void addCharts(Drawing& drawing, const Figure& figure, const PageBox& box) {
    const int count = static_cast<int>(figure.charts.size());
    const int columns = std::min(figure.columns, count), rows = (count + columns - 1) / columns;
    const double share = columns * rows == 1 ? 1 : columns <= 2 && rows <= 2 ? 0.9 : 0.8;
    const double text = textSize(figure);
    const double gap = 28, below = legendHeight(figure);
    const double width = (box.right - box.left + gap) / columns;
    const double height = (box.bottom - box.top + gap) / rows;
    for (int i = 0; i < count; ++i) {
        const int column = i % columns, row = i / columns;
        const Chart& chart = figure.charts[static_cast<std::size_t>(i)];
        PageBox cell{box.left + column * width, box.top + row * height, 0, 0};
        cell.right = cell.left + width - gap;
        cell.bottom = cell.top + height - gap - below;
        addChart(drawing, chart, cell, share * text);
        if (figure.legendBelow)
            addLegend(drawing, legendEntries({&chart, 1}),
                      {cell.left, cell.bottom + 10, cell.right, cell.bottom + below}, text);
    }
}

}  // namespace

Drawing figureDrawing(const Figure& figure) {
    checkFigure(figure);
    Drawing drawing{figure.width, figure.height, figure.title, chartGround, {}};
    const double room = figure.width - 2 * margin, size = textSize(figure);
    double top = margin;
    if (!figure.title.empty()) {
        addWord(drawing, margin, top + 24 * size, figure.title, {Weight::semibold, 30 * size, ink},
                Anchor::left, room);
        top += 44 * size;
    }
    if (!figure.note.empty()) {
        addWord(drawing, margin, top + 16 * size, figure.note,
                {Weight::regular, 18 * size, chartQuiet}, Anchor::left, room);
        top += 34 * size;
    }
    const std::vector<LegendEntry> entries = legendEntries(figure.charts);
    PageBox box{margin, top, figure.width - margin, figure.height - 0.7 * margin};
    if (!entries.empty() && !figure.legendBelow) {
        const double width = legendWidth(entries, size);
        addLegend(drawing, entries, {box.right - width, top + 30 * size, box.right, box.bottom},
                  size);
        box.right -= width + 20;
    }
    addCharts(drawing, figure, box);
    return drawing;
}

std::string figureSvg(const Figure& figure) { return drawingSvg(figureDrawing(figure)); }

Picture figurePicture(const Figure& figure, double scale) {
    return drawingPicture(figureDrawing(figure), scale);
}

void writeFigure(const std::filesystem::path& path, const Figure& figure) {
    const std::string svg = figureSvg(figure);
    WholeFile file(path.string() + ".svg");
    file.write(std::as_bytes(std::span(svg)));
    writePng(path.string() + ".png", figurePicture(figure));
    file.commit();
}

std::vector<ChartPoint> paretoFront(std::vector<ChartPoint> points) {
    std::sort(points.begin(), points.end(), [](const ChartPoint& a, const ChartPoint& b) {
        return a.x != b.x ? a.x < b.x : a.y < b.y;
    });
    std::vector<ChartPoint> front;
    for (const ChartPoint& point : points)
        if (front.empty() || point.y < front.back().y) front.push_back(point);
    return front;
}

}  // namespace plait
