#include "render/svg_canvas.h"

#include <algorithm>
#include <cstdio>

namespace render {

namespace {

constexpr int kCaptionHeight = 24;     // px
constexpr int kStripe = 5, kDash = 7;  // px

// One digit behind the point, none if it is zero.
std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    std::string digits = text;
    if (digits.size() > 2 && digits.compare(digits.size() - 2, 2, ".0") == 0)
        digits.resize(digits.size() - 2);
    return digits == "-0" ? "0" : digits;
}

std::string escaped(const std::string &text) {
    std::string result;
    for (char c : text) result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
    return result;
}

}  // namespace

SvgCanvas::SvgCanvas(const Area &area, int width)
    : m_area(area), m_width(width), m_scale(width / std::max(area.right - area.left, 1e-9)) {}

std::string SvgCanvas::place(const Point &point) const {
    return number((point.x - m_area.left) * m_scale) + " " +
           number((point.y - m_area.top) * m_scale + kCaptionHeight);
}

std::string SvgCanvas::fill(const std::vector<Colour> &fills) {
    if (fills.size() == 1) return fills.front().text();
    const std::string size = std::to_string(kStripe * static_cast<int>(fills.size()));
    std::string definition = "width=\"" + size + "\" height=\"" + size +
                             "\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\">";
    for (std::size_t i = 0; i < fills.size(); ++i)
        definition += "<rect x=\"" + std::to_string(kStripe * static_cast<int>(i)) + "\" width=\"" +
                      std::to_string(kStripe) + "\" height=\"" + size + "\" fill=\"" + fills[i].text() +
                      "\"/>";
    const auto [pattern, isNew] = m_patterns.insert({definition, "p" + std::to_string(m_patterns.size())});
    return "url(#" + pattern->second + ")";
}

// The attributes of one colour of a stroke: the first is continuous, the others are dashes upon it.
std::string SvgCanvas::stroked(const Stroke &stroke, std::size_t colour) {
    if (stroke.colours.empty()) return "";
    std::string text =
        " stroke=\"" + stroke.colours[colour].text() + "\" stroke-width=\"" + number(stroke.width) + "\"";
    if (colour == 0) return text;
    const int others = static_cast<int>(stroke.colours.size()) - 1;
    return text + " stroke-dasharray=\"" + std::to_string(kDash) + " " + std::to_string(kDash * others) +
           "\" stroke-dashoffset=\"" + std::to_string(kDash * static_cast<int>(colour)) + "\"";
}

void SvgCanvas::polygon(const std::vector<Point> &corners, const std::vector<Colour> &fills,
                        const Stroke &stroke, double opacity) {
    std::string outline = "<path d=\"";
    for (std::size_t i = 0; i < corners.size(); ++i) outline += (i == 0 ? "M" : "L") + place(corners[i]);
    outline += "z\"";
    m_body += outline + " fill=\"" + fill(fills) + "\"";
    if (opacity < 1) m_body += " fill-opacity=\"" + number(opacity) + "\"";
    m_body += stroked(stroke, 0) + "/>\n";
    for (std::size_t i = 1; i < stroke.colours.size(); ++i)
        m_body += outline + " fill=\"none\"" + stroked(stroke, i) + "/>\n";
}

void SvgCanvas::ring(const Point &centre, double radius, const Stroke &stroke) {
    m_body += "<circle cx=\"" + number((centre.x - m_area.left) * m_scale) + "\" cy=\"" +
              number((centre.y - m_area.top) * m_scale + kCaptionHeight) + "\" r=\"" + number(radius) +
              "\" fill=\"none\"" + stroked(stroke, 0) + "/>\n";
}

void SvgCanvas::lines(const std::vector<std::array<Point, 2>> &lines, const Stroke &stroke) {
    m_body += "<path d=\"";
    for (const auto &[from, to] : lines) m_body += "M" + place(from) + "L" + place(to);
    m_body += "\" fill=\"none\"" + stroked(stroke, 0) + "/>\n";
}

std::string SvgCanvas::document() const {
    const std::string width = std::to_string(m_width),
                      height = number((m_area.bottom - m_area.top) * m_scale + kCaptionHeight);
    std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + width + " " + height +
                       "\" width=\"" + width + "\" height=\"" + height +
                       "\" role=\"img\" stroke-linejoin=\"round\">\n<title>" + escaped(m_caption) +
                       "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
    if (!m_patterns.empty()) text += "<defs>\n";
    for (const auto &[definition, name] : m_patterns)
        text += "<pattern id=\"" + name + "\" " + definition + "</pattern>\n";
    if (!m_patterns.empty()) text += "</defs>\n";
    text += m_body;
    return text + "<rect width=\"100%\" height=\"" + std::to_string(kCaptionHeight) +
           "\" fill=\"#ffffff\"/>\n<text x=\"6\" y=\"17\" font-family=\"sans-serif\" font-size=\"15\" "
           "fill=\"#222222\">" +
           escaped(m_caption) + "</text>\n</svg>\n";
}

}  // namespace render
