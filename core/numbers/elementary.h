// Elementary functions that may reach a state: the same bits on every x86-64 processor, from every
// compiler and at every level, given -ffp-contract=off. libm's own change with the processor.
//
// Only +, -, *, / in a fixed order. Constants are minimax fits of this project's own; the
// splittings are Cody & Waite, Software Manual for the Elementary Functions (1980), and Dekker
// (1971). The measured errors are printed by test_elementary.cpp. See arctangent.h for
// arctangent2.
#pragma once

#include "arctangent.h"

namespace plait {

// Sine and cosine of x rad, within 1 ulp for |x| <= 1e6; NaN beyond and for what is not a number.
double sine(double x);
double cosine(double x);

// e^x within 1 ulp. 0 below -708.39 (no denormal results), infinity above 709.78.
double exponential(double x);

// ln x within 1 ulp, for x > 0. -infinity for zero and denormals of either sign, NaN for x < 0.
double logarithm(double x);

// base^exponent for base > 0, relative error below 1e-14; exponent 0 gives 1. Base 0 (or denormal)
// gives 0, 1 or infinity by the sign of the exponent, base < 0 gives NaN. Range of the result as
// exponential's.
double power(double base, double exponent);

}  // namespace plait
