// Damping ratios of the normal laws from the coefficient of restitution that a user asks for.
#pragma once

namespace scree {

/// Of the linear law in its plain form, which pulls at the end of a contact: -ln e/sqrt(pi^2 + ln^2 e) (report, 2.17;
/// thesis, 3.40). e in (0, 1], else InputError.
double damping_for_restitution_plain(double e);

/// Of the linear law that does not pull: the root of restitution_without_tension(zeta) = e. e in [1e-4, 1], else
/// InputError; below exp(-2) the contact is overdamped (zeta > 1).
double damping_for_restitution_linear(double e);

/// Of the Hertz law with Tsuji's dashpot, without pull. With x = 2/sqrt(5) delta^(5/4) its motion in the phase plane
/// is that of the linear law, w dw/dx + 2 beta w + x = 0 (after Antypov and Elliott 2011), and so is the point where
/// the force vanishes: the ratio is the same.
double damping_for_restitution_hertz(double e);

/// Restitution of a spring-dashpot that does not pull: exp(-2 zeta acos(zeta)/sqrt(1 - zeta^2)), exp(-2) at zeta = 1,
/// and with acosh and zeta^2 - 1 beyond (Schwager and Poeschel 2007).
double restitution_without_tension(double zeta);

}  // namespace scree
