#include "web_page.h"

#include "machine.h"
#include "render/charts/chart.h"

#include <cstdio>

namespace plait {

std::string webPage(const std::string& title, const std::string& body) {
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<title>" +
           escaped(title) +
           "</title>\n<style>body{background:#faf6ef;color:#16202c;font:16px/1.5 Inter,DejaVu "
           "Sans,sans-serif;max-width:1280px;margin:2em auto;padding:0 1em}img{width:100%}"
           "table{border-collapse:collapse;margin:1.5em 0}td,th{border-bottom:1px solid #dcd5ca;"
           "padding:2px 12px;text-align:right;font-variant-numeric:tabular-nums}"
           "td:first-child,th:first-child{text-align:left}</style></head><body>\n<h1>" +
           escaped(title) + "</h1>\n" + body + "</body></html>\n";
}

std::string pictureLine(const std::string& file, const std::string& words) {
    return "<p><img src=\"" + file + ".svg\" alt=\"" + escaped(words) + "\"></p>\n";
}

std::string commandLines(const std::string& command) {
    const Machine machine = thisMachine();
    char memory[32];
    std::snprintf(memory, sizeof memory, "%.1f GB", machine.memory / 1e9);
    return "<pre>" + escaped(command) + "</pre>\n<p>" +
           escaped(machine.processor + ", " + std::to_string(machine.cores) + " cores, " + memory +
                   ", " + machine.system + ", kernels " + machine.kernels + " with " +
                   std::to_string(machine.lanes) + " lanes") +
           "</p>\n";
}

}  // namespace plait
