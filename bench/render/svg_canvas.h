// An SVG document in the making. Coordinates are those of the camera's screen (m); the canvas maps them to
// pixels.
#pragma once

#include "loader/load_error.h"
#include "render/area.h"
#include "render/colour.h"

#include <map>
#include <string>
#include <vector>

namespace render {

class SvgCanvas {
public:
    SvgCanvas(const Area &area, int width);

    struct Stroke {
        std::vector<Colour> colours;  // several: in dashes; none: no stroke
        double width = 0.5;           // px
    };

    // Closed. Several fills: in stripes.
    void polygon(const std::vector<Point> &corners, const std::vector<Colour> &fills, const Stroke &stroke,
                 double opacity = 1);
    void ring(const Point &centre, double radius, const Stroke &stroke);  // radius: px
    void lines(const std::vector<std::array<Point, 2>> &lines, const Stroke &stroke);
    double pixels(double metres) const { return metres * m_scale; }
    void caption(const std::string &text) { m_caption = worlds::printable(text); }

    std::string document() const;

private:
    std::string place(const Point &point) const;
    static std::string stroked(const Stroke &stroke, std::size_t colour);
    std::string fill(const std::vector<Colour> &fills);

    Area m_area;
    int m_width;
    double m_scale;  // px / m
    std::string m_caption, m_body;
    std::map<std::string, std::string> m_patterns;  // definition -> name
};

}  // namespace render
