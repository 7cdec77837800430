// The page of a scene: what it shows, what it is made of, and what is known of it.
#include "drawing.h"
#include "formula.h"
#include "site.h"

#include <algorithm>

namespace plait {
namespace {

constexpr const char* up = "../";

std::string tagLinks(const Site& site, const SceneFacts& scene) {
    std::string html = "<ul class=\"tags\">";
    const auto add = [&](const std::string& facet, const std::string& value,
                         const std::string& words) {
        html += "<li>" +
                linkTo(std::string(up) + "index.html#" + facet + "=" + slugOf(value), words) +
                "</li>";
    };
    for (const std::string& effect : scene.effects) add("effect", effect, effect);
    for (const std::string& id : site.sectionsOf(scene))
        add("seeds", id, id + " " + site.seeds.section(id)->words);
    return html + "</ul>\n";
}

std::string headOf(const Site& site, const SceneFacts& scene) {
    const std::string& name = scene.entry->name;
    const std::string clip = site.left.clip(name), picture = site.left.picture(name);
    const Settings made = site.left.settings(name);
    std::string html =
        "<section class=\"slide hero\" id=\"clip\" aria-labelledby=\"title\">\n<div>"
        "<h1 id=\"title\">" +
        escaped(scene.entry->title) + "</h1>\n<p class=\"lesson\">" + escaped(scene.entry->lesson) +
        ".</p>\n" + tagLinks(site, scene) + "</div>\n";
    html += clipOf(clip.empty() ? "" : up + clip, picture.empty() ? "" : up + picture,
                   scene.entry->title + ": " + scene.entry->lesson);
    if (clip.empty())
        html += missing("There is no clip of this scene here yet.",
                        "build/plait run " + name + " -q " + scene.quality);
    else
        html += "<p class=\"note\">Simulated at " + escaped(valueOf(made, "quality")) +
                " quality: <code>build/plait run " + name + " -q " +
                escaped(valueOf(made, "quality")) + "</code></p>\n";
    return html + "</section>\n";
}

std::string counted(int count, const std::string& one, const std::string& many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string sizeWords(const SceneFacts& scene) {
    std::string words = counted(scene.vertices, "vertex", "vertices");
    if (scene.pinned > 0) words += " (" + std::to_string(scene.pinned) + " pinned)";
    if (scene.edges > 0) words += ", " + counted(scene.edges, "edge", "edges");
    if (scene.triangles > 0) words += ", " + counted(scene.triangles, "triangle", "triangles");
    if (scene.tetrahedra > 0)
        words += ", " + counted(scene.tetrahedra, "tetrahedron", "tetrahedra");
    return words;
}

std::string omissionSection(const SceneFacts& scene) {
    if (scene.entry->omissions.empty()) return "";
    std::vector<std::string> items;
    for (const std::string& words : scene.entry->omissions) items.push_back(escaped(words));
    return sectionOf("left-out", "What is left out, and why",
                     "<p>A scene has no more than it needs.</p>" + listOf(items));
}

}  // namespace

std::string clipOf(const std::string& clip, const std::string& picture, const std::string& words) {
    if (clip.empty() && picture.empty()) return "<div class=\"clip none\"></div>\n";
    if (clip.empty())
        return R"(<img class="clip" src=")" + escaped(picture) + "\" alt=\"" + escaped(words) +
               "\" width=\"480\" height=\"270\">\n";
    return R"(<video class="clip" src=")" + escaped(clip) + "\"" +
           (picture.empty() ? std::string() : " poster=\"" + escaped(picture) + "\"") +
           " aria-label=\"" + escaped(words) +
           "\" width=\"480\" height=\"270\" muted loop playsinline controls preload=\"metadata\" "
           "data-autoplay></video>\n";
}

std::string scheduleSection(const SceneFacts& scene) {
    std::vector<std::string> links;
    for (const SetFacts& set : scene.sets)
        links.push_back(set.topics.empty() ? ""
                                           : up + folderOf(set.topics[0]->sort) + "/" +
                                                 set.topics[0]->name + ".html");
    std::string forces;
    for (const std::string& force : scene.forces) {
        const Topic* topic = topicOf(TopicSort::force, force);
        forces += (forces.empty() ? "" : ", ") +
                  (topic ? linkTo(std::string(up) + "forces/" + topic->name + ".html", force)
                         : escaped(force));
    }
    const Topic* method = topicOf(TopicSort::method, scene.method());
    std::string html =
        "<ol class=\"steps\">\n<li><b>Forces</b> " + (forces.empty() ? "none" : forces) +
        "</li>\n<li><b>Prediction</b> everything goes where it would by itself</li>\n"
        "<li><b>Constraints</b> put it right, as drawn below, by " +
        linkTo(std::string(up) + "methods/" + method->name + ".html", method->title) +
        "</li>\n<li><b>Velocities</b> are what came of it (" +
        escaped(valueOf(scene.settings, "integrator") == "bdf2" ? "BDF2, of second order"
                                                                : "of first order") +
        ")</li>\n</ol>\n<p>A substep takes these four steps. " + escaped(scheduleWords(scene)) +
        "</p>\n" + scheduleDrawing(scene, links);
    std::vector<std::vector<std::string>> rows;
    for (const auto& set : scene.sets) {
        std::string kinds;
        for (const Topic* topic : set.topics)
            kinds += (kinds.empty() ? "" : ", ") +
                     linkTo(std::string(up) + "constraints/" + topic->name + ".html", topic->title);
        rows.push_back({escaped(set.name), kinds, std::to_string(set.evaluations),
                        set.constraints > 0
                            ? std::to_string(set.constraints)
                            : (set.contact ? "as many as meet" : "as many as need it")});
    }
    html += tableOf("Sets of constraints at " + scene.quality,
                    {"set", "what it is", "evaluations a substep", "constraints"}, rows);
    html += "<p class=\"note\">" + sizeWords(scene) + ".</p>\n";
    return sectionOf("schedule", "What it is made of", html);
}

std::string equationSection(const SceneFacts& scene) {
    std::string html = "<div class=\"equations\">\n";
    for (const Topic* topic : scene.topics()) {
        const Equation& first = topic->equations.front();
        html += "<article><h3>" +
                linkTo(std::string(up) + folderOf(topic->sort) + "/" + topic->name + ".html",
                       topic->title) +
                "</h3><p>" + escaped(topic->lesson) + "</p>" + mathMl(first.tex) +
                "<p class=\"note\">" + withFormulas(first.words) + "</p></article>\n";
    }
    return sectionOf("equations", "Its equations", html + "</div>\n");
}

SitePage scenePage(Site& site, const SceneFacts& scene) {
    SitePage page{.path = "scenes/" + scene.entry->name + ".html",
                  .title = scene.entry->title,
                  .room = "scenes",
                  .body = {}};
    page.body = headOf(site, scene) + scheduleSection(scene) + equationSection(scene) +
                knobSection(site, scene) + metricSection(site, scene) + ledgerSection(site, scene) +
                studySection(site, scene) + failureSection(site, scene) + testSection(site, scene) +
                omissionSection(scene) + sourceSection(site, scene) + commandSection(scene);
    return page;
}

}  // namespace plait
