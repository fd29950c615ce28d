/** Why a measurement is rejected, in the order of their digit keys; the operator can act on each. */
export const REASONS = [
  "review-reason-contact",
  "review-reason-point",
  "review-reason-frame",
  "review-reason-hidden",
  "review-reason-side",
  "review-reason-wrong",
] as const;
