"""The only place that knows HTTP: routes, bodies, session, who is asking."""
