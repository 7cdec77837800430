#include "dance.h"

#include <plait/numbers/elementary.h>

namespace plait::dancer {
namespace {

constexpr double degree = 0.017453292519943295;

// Direction and extension of the wrist, elbow, palm.
using Arm = std::array<double, 10>;

// Arms, by the words of the dance.
const Track<10>& armTrack(std::size_t side) {
    constexpr Arm low{0.60, -0.77, 0.24, 0.955, 0.35, 0.25, -1, -0.75, -0.05, 0.65};
    constexpr Arm first{-0.02, -0.40, 0.90, 0.86, 1, -0.10, 0.10, -0.35, 0.25, -0.90};
    constexpr Arm second{0.94, -0.10, 0.33, 0.962, 0.10, 0.30, -1, -0.35, -0.35, 0.87};
    constexpr Arm fifth{0.03, 0.95, 0.27, 0.865, 1, 0.00, 0.15, -0.55, -0.70, -0.10};
    constexpr Arm ahead{-0.10, 0.16, 1, 0.985, 0.80, -0.55, 0, 0.10, -1, 0.10};
    constexpr Arm aside{0.97, 0.02, -0.22, 0.985, 0.10, -0.30, -1, 0, -1, 0.15};
    constexpr Arm high{0.42, 0.88, 0.16, 0.97, 0.85, -0.10, -0.50, -0.30, -0.45, 0.85};
    static const Track<10> left{
        {0.0, low},    {0.7, low},     {1.35, first}, {2.05, fifth}, {2.75, fifth},  {3.4, second},
        {3.8, second}, {4.1, first},   {4.6, fifth},  {6.1, fifth},  {6.6, first},   {7.4, ahead},
        {8.6, ahead},  {9.2, low},     {9.75, first}, {10.2, ahead}, {10.75, ahead}, {11.3, second},
        {11.9, low},   {12.8, second}, {14, second}};
    static const Track<10> right{
        {0.0, low},    {0.7, low},   {1.35, first}, {2.05, fifth}, {2.75, fifth},  {3.4, first},
        {3.8, first},  {4.1, first}, {4.6, fifth},  {6.1, fifth},  {6.6, first},   {7.4, aside},
        {8.6, aside},  {9.2, low},   {9.75, first}, {10.2, aside}, {10.75, aside}, {11.3, second},
        {11.9, first}, {12.8, high}, {14, high}};
    return side == 0 ? left : right;
}

// A free leg: direction and extension of the ankle, knee, how pointed.
using Leg = std::array<double, 8>;
constexpr Leg under{0, -1, 0.05, 0.97, 0.70, 0, 0.70, 0.5};
constexpr Leg retire{0.03, -0.92, 0.38, 0.53, 1, 0.30, 0.30, 1};
constexpr Leg passe{0.30, -0.94, 0.05, 0.62, 1, 0.20, 0.20, 1};
constexpr Leg behind{0.10, -0.90, -0.42, 0.96, 0.90, 0.10, 0.20, 1};
constexpr Leg arabesque{0.10, -0.40, -0.92, 0.993, 1, 0, -0.05, 1};
constexpr Leg stepping{0.08, -0.90, 0.42, 0.88, 0.55, 0.2, 0.80, 0.8};
constexpr Leg passing{0.34, -0.92, 0.10, 0.72, 0.90, 0.1, 0.50, 1};
constexpr Leg brush{0.22, -0.90, 0.10, 0.60, 0.90, 0.1, 0.50, 1};
constexpr Leg splitFront{0.07, -0.03, 1, 0.993, 0.60, 0.90, 0.05, 1};
constexpr Leg splitBack{0.10, -0.20, -1, 0.993, 1, -0.10, -0.10, 1};
constexpr Leg landingFront{0.02, -0.955, 0.29, 0.92, 0.60, 0.2, 0.80, 0.9};
constexpr Leg trailing{0.10, -0.55, -0.80, 0.985, 1, 0, -0.05, 1};

const Track<8>& legTrack(std::size_t side) {
    static const Track<8> left{{9.0, under},      {9.35, behind},   {9.62, passing},
                               {9.9, stepping},   {10.1, behind},   {10.38, splitBack},
                               {10.75, trailing}, {11.3, trailing}, {11.9, behind}};
    static const Track<8> right{
        {2.9, under},      {3.75, behind},      {3.98, passe},       {4.2, retire},
        {6.3, retire},     {6.52, passe},       {6.85, behind},      {7.55, arabesque},
        {8.55, arabesque}, {8.95, passing},     {9.25, stepping},    {9.75, behind},
        {9.90, brush},     {10.34, splitFront}, {10.42, splitFront}, {10.63, landingFront}};
    return side == 0 ? left : right;
}

// How much it is planted.
const Track<1>& plantTrack(std::size_t side) {
    static const Track<1> left{{9.3, {1}},     {9.48, {0}},           {9.58, {0}}, {9.78, {1}},
                               {takeOff, {1}}, {takeOff + 0.12, {0}}, {11.5, {0}}, {12.0, {1}}};
    static const Track<1> right{
        {3.8, {1}}, {4.02, {0}},           {8.9, {0}},    {9.25, {1}}, {9.72, {1}},
        {9.9, {0}}, {landing - 0.16, {0}}, {landing, {1}}};
    return side == 0 ? left : right;
}

// Where: x, height, z of the tip, heading (degrees), rise.
const Track<5>& footTrack(std::size_t side) {
    constexpr double turn = -990;
    static const Track<5> left{{1.4, {0.215, 0, 0.09, 55, 0}},
                               {1.9, {0.215, 0, 0.09, 55, 1}},
                               {2.78, {0.215, 0, 0.09, 55, 1}},
                               {3.3, {0.215, 0, 0.09, 55, 0}},
                               {3.74, {0.215, 0, 0.09, 55, 0}},
                               {3.93, {0.215, 0, 0.09, 53, 0.6}},
                               {4.1, {0.215, 0, 0.09, 10, 1}},
                               {4.4, {0.215, 0, 0.09, -85, 1}},
                               {5.75, {0.215, 0, 0.09, -785, 1}},
                               {6.15, {0.215, 0, 0.09, turn + 55, 1}},
                               {6.62, {0.215, 0, 0.09, turn + 55, 1}},
                               {7.0, {0.215, 0, 0.09, turn + 55, 0}},
                               {7.1, {0.215, 0, 0.09, turn + 55, 0}},
                               {7.45, {0.215, 0, 0.09, turn + 55, 1}},
                               {8.6, {0.215, 0, 0.09, turn + 55, 1}},
                               {8.97, {0.215, 0, 0.09, turn + 55, 0}},
                               {9.05, {0.215, 0, 0.09, turn + 55, 0}},
                               {9.3, {0.215, 0, 0.09, turn + 55, 1}},
                               {9.58, {1.05, 0.15, 0.02, turn + 40, 0.8}},
                               {9.7, {1.40, 0.065, 0.02, turn + 28, 0.3}},
                               {9.78, {1.50, 0, 0.02, turn + 25, 0}},
                               {9.9, {1.50, 0, 0.02, turn + 25, 0}},
                               {takeOff, {1.50, 0, 0.02, turn + 25, 1}},
                               {11.0, {2.3, 0.2, 0.05, turn + 30, 1}},
                               {11.5, {2.52, 0.05, 0.05, turn + 30, 1}},
                               {12.0, {2.50, 0, 0.04, turn + 20, 1}}};
    static const Track<5> right{{1.4, {-0.215, 0, 0.09, -55, 0}},
                                {1.9, {-0.215, 0, 0.09, -55, 1}},
                                {2.75, {-0.215, 0, 0.09, -55, 1}},
                                {3.15, {-0.14, 0.04, -0.05, -58, 0.8}},
                                {3.5, {-0.10, 0, -0.16, -60, 0}},
                                {3.68, {-0.10, 0, -0.16, -60, 0}},
                                {3.92, {-0.10, 0, -0.16, -60, 1}},
                                {8.9, {0.50, 0.16, 0.30, turn - 25, 0.8}},
                                {9.1, {0.68, 0.06, 0.27, turn - 25, 0.4}},
                                {9.25, {0.74, 0, 0.25, turn - 25, 0}},
                                {9.38, {0.74, 0, 0.25, turn - 25, 0}},
                                {9.68, {0.74, 0, 0.25, turn - 25, 1}},
                                {9.85, {1.0, 0.16, 0.25, turn - 28, 1}},
                                {10.1, {2, 0.05, 0.25, turn - 30, 1}},
                                {10.45, {2.90, 0, 0.24, turn - 35, 1}},
                                {landing, {2.90, 0, 0.24, turn - 35, 0.9}},
                                {landing + 0.13, {2.90, 0, 0.24, turn - 35, 0}}};
    return side == 0 ? left : right;
}

struct Body {
    // Degrees. Heading; pelvis forward and to her left side; chest and head relative to it:
    // forward, turned to her left, to her left side.
    Track<1> heading{{3.86, {0}},    {4.1, {-35}},   {4.4, {-140}},  {5.75, {-840}},
                     {6.15, {-990}}, {11.6, {-990}}, {12.6, {-1030}}};
    Track<2> pelvis{{0.7, {0, 0}},   {1.35, {2, 0}},  {2.0, {0, 0}},    {3.4, {0, 0}},
                    {3.7, {4, 0}},   {4.15, {0, 2}},  {6.3, {0, 2}},    {6.8, {6, 0}},
                    {7.5, {30, 2}},  {8.55, {30, 2}}, {9.1, {4, 0}},    {9.85, {4, 0}},
                    {10.38, {4, 0}}, {10.5, {4, 0}},  {10.85, {14, 0}}, {11.2, {12, 0}},
                    {11.9, {0, 0}}};
    Track<3> chest{
        {0.7, {0, 0, 0}},   {1.35, {0, 0, 0}},  {2.05, {-5, 0, 0}},   {2.75, {-5, 0, 0}},
        {3.4, {0, 14, 0}},  {3.75, {2, 22, 0}}, {4.15, {-3, -6, 0}},  {4.6, {-4, 0, 0}},
        {6.2, {-4, 0, 0}},  {6.8, {-4, 0, 0}},  {7.5, {-30, 0, 0}},   {8.55, {-30, 0, 0}},
        {9.1, {0, 0, 0}},   {9.85, {0, 0, 0}},  {10.38, {-18, 0, 0}}, {10.6, {-16, 0, 0}},
        {11.0, {-8, 0, 0}}, {11.9, {0, 0, 0}},  {12.8, {-12, -18, 4}}};
    Track<3> head{{0.7, {0, 0, 0}},     {1.35, {6, 14, 0}},   {2.05, {-6, 0, 0}},
                  {2.75, {-6, 0, 0}},   {3.4, {0, -14, 0}},   {3.8, {0, -22, 0}},
                  {4.2, {0, 0, 0}},     {6.2, {0, 0, 0}},     {7.5, {-6, 0, 0}},
                  {8.55, {-6, 0, 0}},   {9.1, {8, -20, 0}},   {9.9, {0, 0, 0}},
                  {10.4, {-8, -12, 0}}, {10.7, {-4, -10, 0}}, {11.2, {6, 0, 0}},
                  {11.9, {4, -10, 0}},  {12.8, {-12, -28, 6}}};
    // How much the head stays behind, and overtakes, in the turns.
    Track<1> spot{{3.8, {0}}, {4.1, {1}}, {5.75, {1}}, {6.15, {0}}};
    // Centre of mass over x and z; height of the hips.
    Track<1> overX{{2.75, {0}},
                   {3.5, {0.055}},
                   {3.7, {0.08}},
                   {4.15, {0.215}},
                   {6.62, {0.215}},
                   {7.0, {0.165}},
                   {7.1, {0.165}},
                   {7.5, {0.215}},
                   {8.55, {0.215}},
                   {8.85, {0.26}},
                   {9.25, {0.60}},
                   {9.75, {1.20}},
                   {takeOff, {leap}, speed},
                   {landing, {leap + speed * (landing - takeOff)}, speed},
                   {11.1, {2.84}},
                   {11.9, {2.82}},
                   {12.8, {2.79}}};
    Track<1> overZ{{1.4, {0.035}},          {1.9, {0.09}},  {2.75, {0.09}}, {3.25, {0.04}},
                   {3.5, {-0.01}},          {3.7, {0.0}},   {4.15, {0.09}}, {6.62, {0.09}},
                   {7.0, {0.16}},           {7.1, {0.16}},  {7.5, {0.09}},  {8.55, {0.09}},
                   {8.9, {0.16}},           {9.25, {0.17}}, {9.75, {0.10}}, {takeOff, {0.10}, 0.08},
                   {landing, {0.14}, 0.08}, {11.1, {0.19}}, {12.8, {0.18}}};
    Track<1> hips{{0.7, {0.91}},   {1.35, {0.76}},    {2.0, {1.03}},     {2.7, {1.03}},
                  {3.25, {0.89}},  {3.65, {0.80}},    {4.2, {1.022}},    {6.45, {1.022}},
                  {7.0, {0.82}},   {7.07, {0.82}},    {7.55, {1.022}},   {8.47, {1.022}},
                  {8.98, {0.84}},  {9.25, {0.83}},    {9.5, {0.83}},     {9.86, {0.72}},
                  {10.08, {0.79}}, {takeOff, {0.88}}, {landing, {0.80}}, {10.8, {0.69}},
                  {11.0, {0.69}},  {11.4, {0.78}},    {12.1, {0.91}}};
    Track<1> flight{{9.88, {0}}, {10.06, {1}}, {10.86, {1}}, {11.1, {0}}};
    static constexpr double leaves = 1.035, lands = 0.97, gravity = 9.81, leap = 1.76, speed = 1.75;
    static constexpr double up =
        (lands - leaves) / (landing - takeOff) + gravity * (landing - takeOff) / 2;
    static constexpr double down = up - gravity * (landing - takeOff);
    Track<1> flightHeight{{9.88, {0.81}, 0, 6},
                          {takeOff, {leaves}, up, -gravity},
                          {landing, {lands}, down, -gravity},
                          {10.86, {0.78}, 0, 0}};
};

// Where the head looks while the body has turned by an angle: ahead for most of it, then it
// overtakes.
double spotted(double turned) {
    constexpr double whole = 360;
    while (turned < 0) turned += whole;
    while (turned >= whole) turned -= whole;
    return whole * step(turned, 60, 300) - turned;
}

}  // namespace

Controls controls(double t) {
    static const Body body;
    const double heading = body.heading(t)[0];
    const auto pelvis = body.pelvis(t);
    const auto chest = body.chest(t), head = body.head(t);
    const double spot = body.spot(t)[0] * spotted(heading);
    Controls c{};
    c.pelvis = turned(0, degree * heading, 0) * turned(degree * pelvis[0], 0, -degree * pelvis[1]);
    c.chest = c.pelvis * turned(degree * chest[0], degree * chest[1], -degree * chest[2]);
    c.head = c.chest * turned(degree * head[0], degree * (head[1] + spot), -degree * head[2]);
    c.balance = {body.overX(t)[0], body.hips(t)[0], body.overZ(t)[0]};
    c.flight = body.flight(t)[0];
    c.flightHeight = body.flightHeight(t)[0];
    for (std::size_t side = 0; side < 2; ++side) {
        const Arm a = armTrack(side)(t);
        c.arms[side] = {{a[0], a[1], a[2]}, a[3], {a[4], a[5], a[6]}, {a[7], a[8], a[9]}};
        const Leg l = legTrack(side)(t);
        const auto foot = footTrack(side)(t);
        c.legs[side] = {.reach = {l[0], l[1], l[2]},
                        .extension = l[3],
                        .knee = {l[4], l[5], l[6]},
                        .pointed = l[7],
                        .planted = plantTrack(side)(t)[0],
                        .tip = {foot[0], foot[1], foot[2]},
                        .heading = degree * foot[3],
                        .rise = foot[4]};
    }
    return c;
}

}  // namespace plait::dancer
